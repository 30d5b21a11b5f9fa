// SPDX-License-Identifier: MIT
#include "runtime/pose_check.h"

#include "features/threat.h"

namespace flinch::runtime {

bool is_usable(const motion::Pose& pose) noexcept {
  constexpr float kUnit = 1e-2F;  // tolerance of a rotation's length
  return is_sound(pose, kUnit) && (pose.root_position.array().abs() <= features::kMaxExtent).all();
}

}  // namespace flinch::runtime
