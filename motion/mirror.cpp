// SPDX-License-Identifier: MIT
#include "motion/mirror.h"

#include <numbers>

#include "motion/rotation.h"

namespace flinch::motion {

Pose mirrored(const Pose& pose) {
  Pose result;
  result.root_position = pose.root_position;
  result.root_position.y() = -pose.root_position.y();
  for (Role role : kRoles) {
    result.rotation[role] = mirrored(pose.rotation[mirrored(role)]);
  }
  return result;
}

namespace {

float mirrored_direction(float direction) {
  constexpr float kAlmostBehind = std::numbers::pi_v<float> - 1e-3F;
  return direction < kAlmostBehind ? -direction : direction;
}

}  // namespace

Clip mirrored(const Clip& clip) {
  Clip result = clip;
  result.name = clip.name + "_mirrored";
  result.mirrored_from = clip.name;
  if (result.annotation) {
    result.annotation->direction = mirrored_direction(result.annotation->direction);
  }
  if (result.push) {
    result.push->place = mirrored(result.push->place);
    result.push->direction = mirrored_direction(result.push->direction);
    result.push->velocity.y() = -result.push->velocity.y();
  }
  for (Pose& pose : result.motion.poses) pose = mirrored(pose);
  return result;
}

}  // namespace flinch::motion
