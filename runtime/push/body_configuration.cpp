// SPDX-License-Identifier: MIT
#include "runtime/push/body_configuration.h"

#include "motion/rotation.h"

namespace flinch::runtime {

BodyConfiguration body_configuration(const motion::Skeleton& skeleton, const motion::Pose& before,
                                     const motion::Pose& now, float dt_s) noexcept {
  const motion::JointFrames from = motion::forward_kinematics(skeleton, before);
  const motion::JointFrames to = motion::forward_kinematics(skeleton, now);
  const Eigen::Quaternionf into_facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), -motion::facing(now));
  const Eigen::Vector3f origin(now.root_position.x(), now.root_position.y(), 0);
  BodyConfiguration configuration;
  for (const motion::Role role : motion::kRoles) {
    const auto row = 3 * static_cast<Eigen::Index>(role);
    const Eigen::Vector3f velocity = (to.position[role] - from.position[role]) / dt_s;
    configuration.segment<3>(row) = into_facing * (to.position[role] - origin);
    configuration.segment<3>(3 * motion::kRoleCount + row) =
        kVelocityWeight_s * (into_facing * velocity);
  }
  return configuration;
}

}  // namespace flinch::runtime
