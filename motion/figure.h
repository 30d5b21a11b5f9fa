// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "motion/body.h"
#include "motion/foot.h"
#include "motion/limb_ik.h"

namespace flinch::motion {

/// A character with its bodies: what authoring poses and measuring them needs.
struct Figure {
  Physique character;
  BodyModel bodies;

  const Skeleton& skeleton() const { return character.skeleton; }
};

Figure make_figure(const Physique& character);

/// Where a wrist goes, world, and which way its elbow.
struct HandGoal {
  Eigen::Vector3f wrist = Eigen::Vector3f::Zero();
  Eigen::Vector3f pole = -Eigen::Vector3f::UnitZ();  ///< the elbow's way at swivel 0
  float swivel = 0;  ///< radians from the pole, positive away from the body
};

/// Bends the legs of a pose so that the feet are at these places, knees over the toes. `trunk` are
/// its joints; only those of pelvis and trunk need be right. Legs too short stretch toward the
/// place; then false is returned.
bool solve_legs(const Skeleton& skeleton, const JointFrames& trunk, const PerSide<FootPose>& feet,
                Pose& pose);

/// The highest that the pelvis may be, world z, m, for both legs to reach their feet with a little
/// bend left. Where a foot is too far aside, as high as it is.
float max_pelvis_height(const Skeleton& skeleton, const JointFrames& trunk,
                        const PerSide<FootPose>& feet);

/// Bends the arm of one side so that its wrist is at this place, and returns the forearm's
/// orientation, world. The hand keeps its rotation relative to the forearm.
Eigen::Quaternionf solve_arm(const Skeleton& skeleton, const JointFrames& trunk, Side side,
                             const HandGoal& place, Pose& pose);

/// The pose with its feet put to these places.
Pose with_feet(const Skeleton& skeleton, const Pose& pose, const PerSide<FootPose>& feet);

/// The swivel of an arm from a pole, radians, positive away from the body: what with_hands needs
/// to bring the elbow back to where it is.
float swivel_of(const JointFrames& frames, Side side, const Eigen::Vector3f& pole);

/// How an arm hangs or rises, radians: from straight down with the palm to the thigh.
struct ArmAngles {
  float flexion = 0;    ///< forward
  float abduction = 0;  ///< sideways, away from the body
  float rotation = 0;   ///< about its length, positive turns the elbow's crook outward
  float elbow = 0;
};
/// Sets an arm's rotations relative to its clavicle; the hand goes straight on.
void set_arm(Pose& pose, Side side, const ArmAngles& angles);

/// The rotation of a joint's group, such as neck and head together: of `to` in the frame of `from`.
Eigen::Quaternionf relative_rotation(const JointFrames& frames, Role from, Role to);

/// Height of the crown in the rest pose, m.
float stature(const Skeleton& skeleton);

}  // namespace flinch::motion
