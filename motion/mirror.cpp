// SPDX-License-Identifier: MIT
#include "motion/mirror.h"

#include <numbers>

namespace flinch::motion {

// A mirror in the plane y = 0 takes the rotation (w, x, y, z) to (w, -x, y, -z): the axis is
// mirrored and the sense of rotation turns round.
Pose mirrored(const Pose& pose) {
  Pose result;
  result.root_position = pose.root_position;
  result.root_position.y() = -pose.root_position.y();
  for (Role role : kRoles) {
    const Eigen::Quaternionf& q = pose.rotation[mirrored(role)];
    result.rotation[role] = Eigen::Quaternionf(q.w(), -q.x(), q.y(), -q.z());
  }
  return result;
}

Clip mirrored(const Clip& clip) {
  constexpr float kAlmostBehind = std::numbers::pi_v<float> - 1e-3F;
  Clip result = clip;
  result.name = clip.name + "_mirrored";
  result.mirrored_from = clip.name;
  if (result.annotation && result.annotation->direction < kAlmostBehind) {
    result.annotation->direction = -result.annotation->direction;
  }
  for (Pose& pose : result.motion.poses) pose = mirrored(pose);
  return result;
}

}  // namespace flinch::motion
