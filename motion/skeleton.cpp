// SPDX-License-Identifier: MIT
#include "motion/skeleton.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "motion/rotation.h"

namespace flinch::motion {

bool has_same_bits(const Pose& first, const Pose& second) {
  const auto is_same = [](const auto& p, const auto& q) {
    return std::memcmp(p.data(), q.data(), sizeof(float) * static_cast<std::size_t>(p.size())) == 0;
  };
  return is_same(first.root_position, second.root_position) &&
         std::ranges::equal(first.rotation, second.rotation, [&](const auto& p, const auto& q) {
           return is_same(p.coeffs(), q.coeffs());
         });
}

// p_i = p_parent + R_parent * offset_i,  R_i = R_parent * r_i,  parents first.
JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose,
                               std::span<const Role> roles) {
  JointFrames frames;
  frames.position[Role::pelvis] = pose.root_position;
  frames.orientation[Role::pelvis] = pose.rotation[Role::pelvis];
  for (Role role : roles) {
    const std::optional<Role> parent = parent_of(role);
    if (!parent) continue;
    const Eigen::Quaternionf& parent_orientation = frames.orientation[*parent];
    frames.position[role] =
        frames.position[*parent] + rotated(skeleton.offset[role], parent_orientation);
    frames.orientation[role] = parent_orientation * pose.rotation[role];
  }
  return frames;
}

JointFrames forward_kinematics(const Skeleton& skeleton, const Pose& pose) {
  return forward_kinematics(skeleton, pose, kRoles);
}

Pose pose_from_frames(const JointFrames& frames) {
  Pose pose;
  pose.root_position = frames.position[Role::pelvis];
  for (Role role : kRoles) {
    const std::optional<Role> parent = parent_of(role);
    const Eigen::Quaternionf& orientation = frames.orientation[role];
    pose.rotation[role] =
        (parent ? frames.orientation[*parent].conjugate() * orientation : orientation).normalized();
  }
  return pose;
}

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  pose.root_position = skeleton.offset[Role::pelvis];
  return pose;
}

float facing(const Pose& pose) {
  return yaw_of(pose.rotation[Role::pelvis]);
}

// |q|^2 - 1 is 2 (|q| - 1) near 1. Comparisons with NaN are false, so this also finds numbers that
// are not finite. Most poses are sound, so all rotations are checked without a branch for each.
bool is_sound(const Pose& pose, float unit_tolerance) noexcept {
  bool sound = pose.root_position.allFinite();
  for (const Eigen::Quaternionf& rotation : pose.rotation) {
    sound &= std::abs(rotation.squaredNorm() - 1) <= 2 * unit_tolerance;
  }
  return sound;
}

void place(float yaw, const Eigen::Vector3f& translation, Pose& pose) {
  const Eigen::Quaternionf turn = rotation_about(Eigen::Vector3f::UnitZ(), yaw);
  Eigen::Quaternionf& pelvis = pose.rotation[Role::pelvis];
  pose.root_position = turn * pose.root_position + translation;
  pelvis = (turn * pelvis).normalized();
}

Pose placed(const Pose& pose, float yaw, const Eigen::Vector3f& translation) {
  Pose result = pose;
  place(yaw, translation, result);
  return result;
}

}  // namespace flinch::motion
