// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "motion/body.h"
#include "motion/foot.h"
#include "motion/limb_ik.h"

namespace flinch::motion {

/// A character and its bodies: what is needed to author and to measure poses.
struct Figure {
  Physique character;
  BodyModel bodies;

  const Skeleton& skeleton() const { return character.skeleton; }
};

Figure make_figure(const Physique& character);

/// Target of one hand: the wrist's position and the direction of the elbow. World.
struct HandGoal {
  Eigen::Vector3f wrist = Eigen::Vector3f::Zero();
  Eigen::Vector3f pole = -Eigen::Vector3f::UnitZ();  ///< direction of the elbow at swivel 0
  float swivel = 0;  ///< radians from the pole; positive away from the body
};

/// Bends the legs of `pose` so that the feet are at `feet`, knees over the toes. `trunk` holds the
/// pose's joint frames; only those of pelvis and trunk need be valid. Returns false if a leg is too
/// short: it is then stretched towards its foot's place.
bool solve_legs(const Skeleton& skeleton, const JointFrames& trunk, const PerSide<FootPose>& feet,
                Pose& pose);

/// Returns the largest pelvis height (world z, m) at which both legs reach their feet with a slight
/// bend. Where a foot is out of reach sideways, its hip is allowed up to the height of its ankle.
float max_pelvis_height(const Skeleton& skeleton, const JointFrames& trunk,
                        const PerSide<FootPose>& feet);

/// Bends the arm of one side so that its wrist is at `place`, and returns the forearm's
/// orientation, world. The hand keeps its rotation relative to the forearm.
Eigen::Quaternionf solve_arm(const Skeleton& skeleton, const JointFrames& trunk, Side side,
                             const HandGoal& place, Pose& pose);

/// Returns the pose with its feet moved to `feet`.
Pose with_feet(const Skeleton& skeleton, const Pose& pose, const PerSide<FootPose>& feet);

/// Returns the swivel angle of an arm about the line from shoulder to wrist, measured from `pole`,
/// radians, positive away from the body. As HandGoal::swivel with the same pole, it reproduces the
/// elbow's position.
float swivel_of(const JointFrames& frames, Side side, const Eigen::Vector3f& pole);

/// Shoulder angles of an arm, radians; all 0: it hangs straight down with the palm to the thigh.
struct ArmAngles {
  float flexion = 0;    ///< forward
  float abduction = 0;  ///< sideways, away from the body
  float rotation = 0;   ///< about its own length; positive turns the inside of the elbow outward
  float elbow = 0;
};
/// Sets an arm's rotations relative to its clavicle; the hand stays in line with the forearm.
void set_arm(Pose& pose, Side side, const ArmAngles& angles);

/// Returns the orientation of `to` in the frame of `from`, for joint groups such as neck and head.
Eigen::Quaternionf relative_rotation(const JointFrames& frames, Role from, Role to);

/// Height of the crown in the rest pose, m.
float stature(const Skeleton& skeleton);

}  // namespace flinch::motion
