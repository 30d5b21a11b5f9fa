// SPDX-License-Identifier: MIT
#include "runtime/pose_check.h"

namespace flinch::runtime {

bool is_usable(const motion::Pose& pose) noexcept {
  constexpr float kUnit = 1e-2F;  // tolerance of a rotation's length
  return is_sound(pose, kUnit) && (pose.root_position.array().abs() <= kMaxPlace_m).all();
}

}  // namespace flinch::runtime
