// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "motion/role.h"

namespace flinch::motion {

/// The joints of a character, one per role.
///
/// In the rest pose the character stands in a T-pose with straight legs and faces +X; every joint's
/// frame is then parallel to the world's (X forward, Y left, Z up), so all rotations of the rest
/// pose are the identity. Left and right are exact mirror images, which makes mirroring exact.
struct Skeleton {
  /// From the parent's joint to this one, in the parent's frame, m. That of the pelvis is its
  /// position in the rest pose, (0, 0, height above the ground).
  PerRole<Eigen::Vector3f> offset;
  /// From the joint to the far end of its segment, in its own frame, m: to the crown of the head,
  /// the fingertips, the tip of the toes; for other joints to the next joint of the chain.
  PerRole<Eigen::Vector3f> tip;
};

/// A pose: the joints' local rotations and the position of the root.
struct Pose {
  Eigen::Vector3f root_position = Eigen::Vector3f::Zero();  ///< of the pelvis joint, world, m
  /// Relative to the parent's frame; that of the pelvis relative to the world. Unit.
  PerRole<Eigen::Quaternionf> rotation;

  /// All rotations the identity, the pelvis at the world's origin.
  Pose() {
    for (Eigen::Quaternionf& joint_rotation : rotation) joint_rotation.setIdentity();
  }
};

/// Whether two poses are the same to the bit.
bool has_same_bits(const Pose& first, const Pose& second);

/// Position and orientation of every joint in the world.
struct JointFrames {
  PerRole<Eigen::Vector3f> position;        ///< m
  PerRole<Eigen::Quaternionf> orientation;  ///< unit
};

/// The joints of a pose in the world. Costs about a microsecond; allocates nothing.
JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose);

/// The same for `roles` only, which are in an order with parents first and hold the parent of each.
/// Does not set the frames of other roles.
JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose,
                               std::span<const Role> roles);

/// The pose with these joint orientations and this position of the pelvis: the inverse of
/// forward_kinematics. Ignores the other positions, which follow from the skeleton.
Pose pose_from_frames(const JointFrames& frames);

/// The rest pose with the feet on the ground.
Pose rest_pose(const Skeleton& skeleton);

/// The horizontal direction that the character faces: the yaw of the pelvis' X axis, radians
/// counter-clockwise from the world's X axis, in (-pi, pi].
float facing(const Pose& pose);

/// Whether all numbers of a pose are finite and its rotations are unit to `unit_tolerance`.
bool is_sound(const Pose& pose, float unit_tolerance = 1e-3F) noexcept;

/// A rigid move on the ground: a turn about the world's vertical through the origin, then a shift.
struct PlanarMove {
  float yaw = 0;                                          ///< radians, counter-clockwise
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< horizontal, m
};

/// The pose turned by `yaw` radians about the world's vertical through the origin, then moved by
/// `translation`, m.
Pose placed(const Pose& pose, float yaw, const Eigen::Vector3f& translation);
/// The same in place.
void place(float yaw, const Eigen::Vector3f& translation, Pose& pose);

}  // namespace flinch::motion
