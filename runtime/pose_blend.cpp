// SPDX-License-Identifier: MIT
#include "runtime/pose_blend.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation.h"

namespace flinch::runtime {

using motion::Pose;
using motion::Role;

Pose blended(const Pose& game, const Pose& ours, const Mask& mask) noexcept {
  const auto weight_of = [&mask](Role role) {
    const float weight = mask.weight * mask.joint[role];
    return std::isfinite(weight) ? std::clamp(weight, 0.0F, 1.0F) : 0.0F;
  };
  Pose result;
  result.root_position =
      game.root_position + weight_of(Role::pelvis) * (ours.root_position - game.root_position);
  for (const Role role : motion::kRoles) {
    result.rotation[role] =
        motion::slerp(game.rotation[role], ours.rotation[role], weight_of(role));
  }
  return result;
}

}  // namespace flinch::runtime
