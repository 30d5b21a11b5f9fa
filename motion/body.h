// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// The rigid bodies of the figure. The joint of one role moves each; clavicles belong to the chest,
/// toes to the foot.
enum class Body : std::uint8_t {
  pelvis,
  abdomen,
  chest,
  neck,
  head,
  left_upper_arm,
  left_forearm,
  left_hand,
  right_upper_arm,
  right_forearm,
  right_hand,
  left_thigh,
  left_shin,
  left_foot,
  right_thigh,
  right_shin,
  right_foot,
};

/// The number of bodies.
inline constexpr int kBodyCount = 17;

/// All bodies, parents first, for range-based loops.
inline constexpr auto kBodies = all_enumerators<Body, kBodyCount>();

/// One value per body.
template <class T>
using PerBody = EnumArray<Body, T, kBodyCount>;

/// The role whose joint moves the body, at its near end.
Role role_of(Body body);
/// The body that the frame of a role's joint is fixed to.
Body body_of(Role role);
/// The parent that a joint connects `body` to; none for the pelvis.
std::optional<Body> parent_of(Body body);
/// The name in files and messages, such as "left_upper_arm".
std::string_view name_of(Body body);
/// The target that a hit on the body counts for: head for head and neck; trunk for chest, abdomen
/// and arms; pelvis; legs for thighs, shins and feet.
Target target_of(Body body);

/// Which of de Leva's tables gives a character's masses.
enum class Sex : std::uint8_t { female, male };
/// The name in files and messages: "female" or "male".
std::string_view name_of(Sex sex);
/// The sex with this name, if there is one.
std::optional<Sex> sex_named(std::string_view name);

/// A character's skeleton and mass.
struct Physique {
  Skeleton skeleton;
  float mass_kg = 70;
  Sex sex = Sex::male;
};

/// The outline of a body for contacts, in the frame of its joint.
struct Shape {
  enum class Kind : std::uint8_t { capsule, box };
  Kind kind = Kind::capsule;
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();                 ///< m
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();  ///< Z is a capsule's axis
  float radius = 0;                                                 ///< of a capsule, m
  float half_length = 0;  ///< of a capsule's axis, without the caps, m
  Eigen::Vector3f half_extents = Eigen::Vector3f::Zero();  ///< of a box, m
};

/// Mass and outline of a body, in the frame of its joint.
struct BodyProperties {
  float mass_kg = 0;
  Eigen::Vector3f centre_of_mass = Eigen::Vector3f::Zero();  ///< m
  Shape shape;
};

/// The masses and outlines of a whole figure.
using BodyModel = PerBody<BodyProperties>;

/// Makes the figure of a character: masses and centres of mass from de Leva (1996), scaled to the
/// character; outlines from its bone lengths and mass. The masses add up to the character's.
///
/// Joints stand for de Leva's landmarks: chest for the xiphion, abdomen for the navel, neck for
/// both suprasternale and cervicale. Limbs and neck are capsules that end at the joints and are as
/// thick as their mass needs; pelvis, abdomen, chest, hands and feet are boxes; the head is an
/// upright capsule from chin to crown. In the rest pose neighbours almost touch, other bodies are
/// clear of each other, and the boxes of the feet lie on the ground. A bone without length gets a
/// body of a few millimetres.
BodyModel make_body_model(const Physique& character);

/// The centre of mass of one body, world, m.
Eigen::Vector3f centre_of_mass(const BodyModel& model, const JointFrames& frames, Body body);

/// The centre of mass of the whole figure, world, m.
Eigen::Vector3f centre_of_mass(const BodyModel& model, const JointFrames& frames);

/// The centre of a target, world, m: the mass-weighted mean of the centres of mass of its core
/// bodies (head; chest and abdomen; pelvis; both thighs and shins).
Eigen::Vector3f target_centre(const BodyModel& model, const JointFrames& frames, Target target);

}  // namespace flinch::motion
