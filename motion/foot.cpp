// SPDX-License-Identifier: MIT
#include "motion/foot.h"

#include <algorithm>
#include <limits>

#include "motion/interpolation.h"

namespace flinch::motion {

FootRoles roles_of(Side side) {
  return side == Side::left ? FootRoles{Role::left_foot, Role::left_toes}
                            : FootRoles{Role::right_foot, Role::right_toes};
}

FootPose foot_pose(const JointFrames& frames, Side side) {
  const Role foot = roles_of(side).foot;
  return {frames.position[foot], frames.orientation[foot]};
}

FootPose blend(const FootPose& from, const FootPose& to, float weight) {
  return {from.ankle + weight * (to.ankle - from.ankle),
          slerp(from.orientation, to.orientation, weight)};
}

float min_height(std::span<const Eigen::Vector3f> points, const Eigen::Quaternionf& orientation) {
  const Eigen::Vector3f up = orientation.conjugate() * Eigen::Vector3f::UnitZ();
  float lowest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& point : points) lowest = std::min(lowest, up.dot(point));
  return lowest;
}

FootDimensions measure_foot(const Skeleton& skeleton, Side side) {
  constexpr float kHeelShare = 0.25F;  // of the foot's length, behind the ankle
  constexpr float kMinLength = 0.01F;  // m, for a skeleton without toes
  const FootRoles roles = roles_of(side);
  const JointFrames rest = forward_kinematics(skeleton, rest_pose(skeleton));
  const Eigen::Vector3f toe_tip = skeleton.offset[roles.toes] + skeleton.tip[roles.toes];
  const Eigen::Vector3f flat(toe_tip.x(), toe_tip.y(), 0);

  FootDimensions foot;
  foot.length = std::max(flat.norm() / (1 - kHeelShare), kMinLength);
  foot.forward = flat.norm() > 0 ? flat.normalized() : Eigen::Vector3f::UnitX();
  foot.ankle_height = rest.position[roles.foot].z();
  foot.heel = -kHeelShare * foot.length * foot.forward;
  foot.heel.z() = -foot.ankle_height;
  return foot;
}

}  // namespace flinch::motion
