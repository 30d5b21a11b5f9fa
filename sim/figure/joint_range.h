// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::sim {

/// How far a joint of the figure goes: a row of motion's human_joint_limits(), or a joint's share
/// of one, for either side. Angles are about the axes of `reference` in the parent's frame,
/// radians: the rotation is a turn of the bone (the two components across its axis) after a twist
/// (the component along it).
struct JointRange {
  Eigen::Quaterniond reference = Eigen::Quaterniond::Identity();  ///< where all angles are 0
  Eigen::Vector3d bone = Eigen::Vector3d::UnitZ();                ///< axis of the bone, unit
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
};

/// The limits of the joint between a body and its parent; the pelvis has none (all zero).
JointRange limits_of(motion::Body body);

/// How a joint turns: a ball joint about all axes; a hinge about one, across the bone; an elbow
/// about that one and, as the forearm's two bones do, along the bone.
enum class JointKind { ball, elbow, hinge };
JointKind kind_of(motion::Body body);

/// The angles of a rotation of the child in its parent's frame.
Eigen::Vector3d joint_angles(const JointRange& limits, const Eigen::Quaterniond& rotation);
/// The rotation that has these angles: the inverse.
Eigen::Quaterniond joint_rotation(const JointRange& limits, const Eigen::Vector3d& angles);

/// The rotation vector, in the parent's frame, that takes the joint back to its limits; zero within
/// them. What the reference does is allowed even beyond them, as its actor could do it.
Eigen::Vector3d limit_violation(const JointRange& limits, const Eigen::Quaterniond& rotation,
                                const Eigen::Quaterniond& reference);

}  // namespace flinch::sim
