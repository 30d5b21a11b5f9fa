// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <numbers>

namespace flinch::database {

constexpr float radians(float degrees) {
  return degrees * std::numbers::pi_v<float> / 180;
}

constexpr float degrees(float radians) {
  return radians * 180 / std::numbers::pi_v<float>;
}

/// The rotation by `angle` radians about a unit axis.
Eigen::Quaternionf turn_about(const Eigen::Vector3f& axis, float angle);

/// A rotation seen in a mirror in the X-Z plane: how the right side does what the left does.
Eigen::Quaternionf mirrored_rotation(const Eigen::Quaternionf& rotation);

}  // namespace flinch::database
