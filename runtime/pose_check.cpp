// SPDX-License-Identifier: MIT
#include "runtime/pose_check.h"

#include <algorithm>
#include <cmath>

#include "features/impact_prediction.h"

namespace flinch::runtime {

bool is_usable(const motion::Pose& pose) noexcept {
  constexpr float kUnit = 1e-2F;  // by which a rotation's length may differ from 1
  // Written so that what is not a number is refused.
  if (!(pose.root_position.array().abs() <= features::kMostExtent).all()) return false;
  return std::ranges::all_of(pose.rotation, [](const Eigen::Quaternionf& rotation) {
    return rotation.coeffs().allFinite() && std::abs(rotation.norm() - 1) < kUnit;
  });
}

}  // namespace flinch::runtime
