// SPDX-License-Identifier: MIT
#include "database/quality/joint_positions.h"

#include <cmath>

namespace flinch::database {
namespace {

using motion::Role;

bool is_stretched_sideways(const JointPositions& joints, Role upper_arm, Role forearm, Role hand) {
  constexpr float kStretched = 0.95F;  // of the arm's length: the elbow within 36 degrees
  constexpr float kLevel = 0.25F;      // the sine of 15 degrees
  const Eigen::Vector3f arm = joints[hand] - joints[upper_arm];
  const float length =
      (joints[forearm] - joints[upper_arm]).norm() + (joints[hand] - joints[forearm]).norm();
  return arm.norm() > kStretched * length && std::abs(arm.z()) < kLevel * length;
}

}  // namespace

float pose_distance(const JointPositions& one, const JointPositions& other) {
  float sum = 0;
  for (Role role : kTrackedJoints) sum += (one[role] - other[role]).squaredNorm();
  return std::sqrt(sum / static_cast<float>(kTrackedJoints.size()));
}

bool is_t_pose(const JointPositions& joints) {
  return is_stretched_sideways(joints, Role::left_upper_arm, Role::left_forearm, Role::left_hand) &&
         is_stretched_sideways(joints, Role::right_upper_arm, Role::right_forearm,
                               Role::right_hand);
}

}  // namespace flinch::database
