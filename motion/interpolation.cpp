// SPDX-License-Identifier: MIT
#include "motion/interpolation.h"

#include <algorithm>
#include <cmath>

namespace flinch::motion {

float ease_in_ease_out(float s) {
  const float t = std::clamp(s, 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

// slerp(p, q, w) = (sin((1-w) a) p + sin(w a) q) / sin a  with cos a = |p . q|
Eigen::Quaternionf slerp(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to,
                         float weight) {
  constexpr float kNearlyParallel = 0.9995F;
  const float dot = from.dot(to);
  const float sign = dot < 0 ? -1.0F : 1.0F;  // q and -q are one rotation: take the nearer
  const float cosine = std::min(std::abs(dot), 1.0F);
  float from_weight = 1 - weight;
  float to_weight = weight;
  if (cosine < kNearlyParallel) {
    const float angle = std::acos(cosine);
    from_weight = std::sin(from_weight * angle) / std::sin(angle);
    to_weight = std::sin(to_weight * angle) / std::sin(angle);
  }
  Eigen::Quaternionf result;
  result.coeffs() = from_weight * from.coeffs() + sign * to_weight * to.coeffs();
  return result.normalized();
}

Pose blend(const Pose& from, const Pose& to, float weight) {
  Pose result;
  result.root_position = (1 - weight) * from.root_position + weight * to.root_position;
  for (Role role : kRoles) {
    result.rotation[role] = slerp(from.rotation[role], to.rotation[role], weight);
  }
  return result;
}

}  // namespace flinch::motion
