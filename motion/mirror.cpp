// SPDX-License-Identifier: MIT
#include "motion/mirror.h"

#include <cstddef>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::motion {
namespace {

PerRole<Role> make_mirrored_roles() {
  PerRole<Role> mirrored_role{};
  for (Role role : kRoles) mirrored_role[role] = mirrored(role);
  return mirrored_role;
}

}  // namespace

void mirror(std::span<const Pose> poses, std::vector<Pose>& images) {
  const Eigen::Vector4f signs(-1, 1, -1, 1);  // mirrored() of a rotation, x y z w, as a product
  const PerRole<Role> mirrored_role = make_mirrored_roles();
  images.resize(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    images[k].root_position = poses[k].root_position;
    images[k].root_position.y() = -poses[k].root_position.y();
    for (Role role : kRoles) {
      const Eigen::Quaternionf& rotation = poses[k].rotation[mirrored_role[role]];
      images[k].rotation[role].coeffs() = rotation.coeffs().cwiseProduct(signs);
    }
  }
}

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
