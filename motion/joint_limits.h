// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "motion/foot.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// Range of motion of one human joint, or of one group of joints.
///
/// The rotation of `to` in the frame of `from` is measured from `reference` and split into a swing
/// and a twist about `axis`, the bone's axis. The three angles are components about x, y and z: the
/// swing's rotation vector, perpendicular to the axis, plus the twist along it. Ranges are given
/// for the left side and the middle; the right side is mirrored before it is measured.
struct JointLimits {
  std::string_view name;  ///< "trunk", "left_shoulder", …
  Role from;
  Role to;
  Eigen::Quaternionf reference;  ///< pose in which all three angles are 0
  Eigen::Vector3f axis;          ///< of the twist: a coordinate axis
  Eigen::Vector3f min;           ///< radians
  Eigen::Vector3f max;
  bool on_right_side = false;
};

/// Returns the table of human joint limits; the .cpp names the source of each row: the American
/// Academy of Orthopaedic Surgeons (1965) for limbs, Kapandji for the trunk, the AMA Guides for the
/// neck.
std::span<const JointLimits> human_joint_limits();

/// Returns the row with that name. Throws Error for a name that is not in the table.
const JointLimits& joint_limits_named(std::string_view name);

/// Returns the three angles of `rotation` (of `to` in the frame of `from`), radians.
Eigen::Vector3f joint_angles(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// Returns the rotation that has these angles: the inverse of joint_angles().
Eigen::Quaternionf rotation_of_angles(const JointLimits& limits, const Eigen::Vector3f& angles);

/// Whether a bound without trigonometry shows that the rotation is within the limits: true of most
/// rotations inside, false of all outside.
bool is_clearly_within(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// Returns by how much the worst of the three angles exceeds its range, radians; 0 inside.
float limit_excess(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// Returns the rotation with each angle clamped to its range.
Eigen::Quaternionf clamp_to_limits(const JointLimits& limits, const Eigen::Quaternionf& rotation);

/// The same, but an angle may be as far beyond its range as that of `motion` is. A rotation whose
/// angles need no clamping keeps its bits.
Eigen::Quaternionf clamp_to_limits(const JointLimits& limits, const Eigen::Quaternionf& rotation,
                                   const Eigen::Quaternionf& motion);

/// Clamps the shoulder and the wrist of an arm to their limits.
void clamp_arm_to_limits(Pose& pose, Side side);

}  // namespace flinch::motion
