// SPDX-License-Identifier: MIT
#include "features/scenario.h"

#include <cstdlib>

namespace flinch::features {

motion::Pose idle_pose(const motion::Motion& idle, const CharacterState& state, float time_s,
                       std::span<const motion::Role> roles) {
  motion::Pose pose = motion::sample_ping_pong(idle, state.idle_time_s + time_s, roles);
  motion::place(state.facing, {state.position.x(), state.position.y(), 0}, pose);
  return pose;
}

bool is_allowed(motion::Target threatened, const std::optional<motion::Annotation>& annotation) {
  if (!annotation) return false;
  return std::abs(static_cast<int>(threatened) - static_cast<int>(annotation->target)) <= 1;
}

}  // namespace flinch::features
