// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::sim {

/// Range of motion of a joint of the figure: a row of motion's human_joint_limits(), or a joint's
/// share of one, for either side. Angles are about the axes of `reference` in the parent's frame,
/// radians. The rotation is a swing of the bone (the two components across its axis) after a twist
/// (the component along it).
struct JointRange {
  Eigen::Quaterniond reference = Eigen::Quaterniond::Identity();  ///< where all angles are 0
  Eigen::Vector3d bone = Eigen::Vector3d::UnitZ();                ///< axis of the bone, unit
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
};

/// Returns the limits of the joint between a body and its parent. The pelvis has none: all zero.
JointRange limits_of(motion::Body body);

/// Degrees of freedom of a joint: a ball joint turns about all axes; a hinge about one, across the
/// bone; an elbow about that one and also along the bone, because the forearm's two bones do; a
/// saddle joint about both axes across the bone; a fixed one about none.
enum class JointKind { ball, elbow, hinge, saddle, fixed };
JointKind kind_of(motion::Body body);
/// The anatomical axis of a hinge or an elbow of people in the parent's frame; zero for others.
Eigen::Vector3d hinge_axis(JointKind kind);

/// Returns the angles of a rotation of the child in its parent's frame.
Eigen::Vector3d joint_angles(const JointRange& limits, const Eigen::Quaterniond& rotation);
/// Returns the rotation that has these angles: the inverse of joint_angles.
Eigen::Quaterniond joint_rotation(const JointRange& limits, const Eigen::Vector3d& angles);

/// Returns the rotation vector, in the parent's frame, that takes the joint back to its limits;
/// zero within them. The reference may exceed them, because its actor did; that much is allowed.
Eigen::Vector3d limit_violation(const JointRange& limits, const Eigen::Quaterniond& rotation,
                                const Eigen::Quaterniond& reference);

}  // namespace flinch::sim
