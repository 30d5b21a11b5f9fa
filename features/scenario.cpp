// SPDX-License-Identifier: MIT
#include "features/scenario.h"

#include <cstdlib>

#include "motion/loop.h"
#include "motion/rotation.h"

namespace flinch::features {

motion::Pose idle_pose(const motion::Loop& stance, const CharacterState& state, float time_s,
                       std::span<const motion::Role> roles) {
  motion::Pose pose = motion::sample(stance, state.idle_time_s + time_s, roles);
  motion::place(state.facing, {state.position.x(), state.position.y(), 0}, pose);
  return pose;
}

CharacterState later(const motion::Loop& stance, const CharacterState& state, float time_s) {
  CharacterState then = state;
  then.idle_time_s += time_s;
  const int cycles = stance.cycles_before(then.idle_time_s);
  if (cycles == 0) return then;
  then.idle_time_s -= static_cast<float>(cycles) * stance.period_s();
  const motion::PlanarMove moved = motion::repeated(stance.travel(), cycles);
  const Eigen::Quaternionf facing = motion::rotation_about(Eigen::Vector3f::UnitZ(), state.facing);
  then.position += (facing * moved.translation).head<2>();
  then.facing += moved.yaw;
  return then;
}

bool is_allowed(motion::Target threatened, const std::optional<motion::Annotation>& annotation) {
  if (!annotation) return false;
  return std::abs(static_cast<int>(threatened) - static_cast<int>(annotation->target)) <= 1;
}

}  // namespace flinch::features
