// SPDX-License-Identifier: MIT
#include "database/angles.h"

namespace flinch::database {

Eigen::Quaternionf turn_about(const Eigen::Vector3f& axis, float angle) {
  return Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis));
}

Eigen::Quaternionf mirrored_rotation(const Eigen::Quaternionf& rotation) {
  return {rotation.w(), -rotation.x(), rotation.y(), -rotation.z()};
}

}  // namespace flinch::database
