// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "motion/foot.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// How far one human joint, or one group of joints, turns.
///
/// The rotation of `to` in the frame of `from` is split into a swing and a twist about `axis`, the
/// bone's, both from `reference`. Its three angles are the swing's rotation vector across the axis
/// and the twist along it, as components about x, y and z. Ranges are written for the left side and
/// the middle; the right side is measured in a mirror.
struct JointLimits {
  std::string_view name;  ///< "trunk", "left_shoulder", …
  Role from;
  Role to;
  Eigen::Quaternionf reference;  ///< where all three angles are 0
  Eigen::Vector3f axis;          ///< of the twist: a coordinate axis
  Eigen::Vector3f min;           ///< radians
  Eigen::Vector3f max;
  bool on_right_side = false;
};

/// The table, with its sources beside each row in the .cpp: the American Academy of Orthopaedic
/// Surgeons (1965) for limbs, Kapandji for the trunk, the AMA Guides for the neck.
std::span<const JointLimits> human_joint_limits();

/// The row with that name. Throws Error for a name that is not in the table.
const JointLimits& joint_limits_named(std::string_view name);

/// The three angles of a rotation of `to` in the frame of `from`, radians.
Eigen::Vector3f joint_angles(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// The rotation that has these angles.
Eigen::Quaternionf rotation_of_angles(const JointLimits& limits, const Eigen::Vector3f& angles);

/// How far the worst of the three angles is beyond its range, radians; 0 within.
float limit_excess(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// The rotation with each angle clamped to its range.
Eigen::Quaternionf clamp_to_limits(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// Clamps shoulder and wrist of an arm to their limits.
void clamp_arm_to_limits(Pose& pose, Side side);

}  // namespace flinch::motion
