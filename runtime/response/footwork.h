// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"
#include "motion/support_polygon.h"

namespace flinch::runtime {

/// Interval in which a foot is off the ground, seconds of the clip.
struct Swing {
  float begin_s = 0;
  float end_s = 0;
};

/// How a clip uses its feet.
struct Footwork {
  motion::PerSide<std::vector<Swing>> swings;  ///< in ascending order of time
  /// The support foot: the foot that carries more weight in the clip's opening. If one foot stays
  /// down while the other leaves the ground before the peak, that foot; otherwise the foot nearer
  /// to the centre of mass.
  motion::Side support = motion::Side::left;
};

/// Outline of a sole, with the convex hull of its contact with the ground.
struct Sole : motion::SoleOutline {
  /// Convex hull of the whole sole on flat ground, counter-clockwise, in the foot's frame seen from
  /// above.
  std::vector<Eigen::Vector2f> hull;
  Eigen::Vector2f middle = Eigen::Vector2f::Zero();  ///< mean of the hull's corners
};

Sole make_sole(const motion::Skeleton& skeleton, motion::Side side);

/// Returns the pelvis and the leg down to the foot, parents first: the joints that determine a
/// foot's position.
std::span<const motion::Role> leg_chain(motion::Side side);

/// Returns ankle and orientation of one foot, world. Cheaper than forward kinematics of all joints.
motion::FootPose foot_of(const motion::Skeleton& skeleton, const motion::Pose& pose,
                         motion::Side side);

/// Returns the height of the lowest point of a sole, world z, m. The foot is at `foot`, and its
/// toes are rotated against it by `toes`. `toes_offset` is the skeleton's.
float min_height(const Sole& sole, const motion::FootPose& foot, const Eigen::Quaternionf& toes,
                 const Eigen::Vector3f& toes_offset);
float min_height(const Sole& sole, const motion::JointFrames& frames, motion::Side side);

/// A foot stands if a point of its sole is within this distance of the ground, m.
inline constexpr float kMaxStandingHeight_m = 0.008F;

/// Returns the footwork of a clip from its onset on or, without an annotation, from its start.
/// Leaves out swings shorter than 0.05 s as noise, and likewise stances between swings.
Footwork footwork_of(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                     const motion::PerSide<Sole>& soles, const motion::Clip& clip);

/// Whether a clip of this onset and duration could have this footwork: a known support foot, and
/// swings in order, from the onset to the end, that are no noise. Does not look at the poses.
bool is_sound(const Footwork& footwork, const motion::Clip& clip);

}  // namespace flinch::runtime
