// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "motion/role.h"

namespace flinch::motion {

/// The joints of a library's character: one a role.
///
/// In the rest pose the character stands in a T-pose with straight legs and faces +X; every joint's
/// frame is then parallel to the world's (X forward, Y left, Z up), so a rest pose is all identity
/// rotations. Left and right are exact mirror images, which makes mirroring exact.
struct Skeleton {
  /// From the parent's joint to this one in the parent's frame, m. The pelvis' is its position
  /// above the ground (0, 0, h) in the rest pose.
  PerRole<Eigen::Vector3f> offset;
  /// From the joint to the far end of its segment, in its own frame, m: the crown for the head, the
  /// fingertips for a hand, the tip of the toes; for others the next joint down the chain.
  PerRole<Eigen::Vector3f> tip;
};

/// Local rotations and the root's place: all that moves.
struct Pose {
  Eigen::Vector3f root_position = Eigen::Vector3f::Zero();  ///< of the pelvis joint, world, m
  /// Relative to the parent's frame; the pelvis' relative to the world. Unit.
  PerRole<Eigen::Quaternionf> rotation;

  /// All rotations identity: the rest pose at the world's origin.
  Pose() {
    for (Eigen::Quaternionf& rotation_of_joint : rotation) rotation_of_joint.setIdentity();
  }
};

/// Where every joint is, in the world.
struct JointFrames {
  PerRole<Eigen::Vector3f> position;        ///< m
  PerRole<Eigen::Quaternionf> orientation;  ///< unit
};

/// A pose's joints in the world. About a microsecond; allocates nothing.
JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose);

/// The same of some roles only: parents first, each after its parent. The frames of others are not
/// set.
JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose,
                               std::span<const Role> roles);

/// The pose that has these joint orientations and this pelvis position: the inverse of
/// forward_kinematics, whose other positions follow from the skeleton.
Pose pose_from_frames(const JointFrames& frames);

/// The rest pose, feet on the ground.
Pose rest_pose(const Skeleton& skeleton);

/// The horizontal direction that the character faces: the yaw of the pelvis' X axis, radians
/// counter-clockwise from the world's X axis, in (-pi, pi].
float facing(const Pose& pose);

/// Whether a pose is finite and its rotations are unit ones to `unit_tolerance`.
bool is_sound(const Pose& pose, float unit_tolerance = 1e-3F) noexcept;

/// Turns the pose by `yaw` radians about the world's vertical through the origin, then moves it.
void place(float yaw, const Eigen::Vector3f& translation, Pose& pose);
Pose placed(const Pose& pose, float yaw, const Eigen::Vector3f& translation);

}  // namespace flinch::motion
