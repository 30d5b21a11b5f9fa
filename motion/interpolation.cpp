// SPDX-License-Identifier: MIT
#include "motion/interpolation.h"

#include <algorithm>
#include <cmath>

namespace flinch::motion {

float ease_in_ease_out(float s) {
  const float t = std::clamp(s, 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

namespace {

// q and -q are one rotation: which of them makes the shorter arc.
float shorter_sign(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to) {
  return from.dot(to) < 0 ? -1.0F : 1.0F;
}

// slerp(p, q, w) = (sin((1-w) a) p + sin(w a) q) / sin a  with cos a = p . q
Eigen::Quaternionf slerp_with_sign(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to,
                                   float sign, float weight) {
  constexpr float kNearlyParallel = 0.9995F;
  const float cosine = std::min(sign * from.dot(to), 1.0F);
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

}  // namespace

float minimum_jerk(float s) {
  const float t = std::clamp(s, 0.0F, 1.0F);
  return t * t * t * (10 - t * (15 - 6 * t));
}

Eigen::Quaternionf slerp(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to,
                         float weight) {
  return slerp_with_sign(from, to, shorter_sign(from, to), weight);
}

Pose blend(const Pose& from, const Pose& to, float weight, std::span<const Role> roles) {
  Pose result;
  result.root_position = (1 - weight) * from.root_position + weight * to.root_position;
  for (Role role : roles) {
    result.rotation[role] = slerp(from.rotation[role], to.rotation[role], weight);
  }
  return result;
}

Pose blend_along_initial_arc(const Pose& from, const Pose& to, float weight,
                             const Pose& from_at_start, const Pose& to_at_start) {
  constexpr float kWholeTurn = -0.95F;  // cosine of half the arc: beyond, the arc has no direction
  Pose result;
  result.root_position = (1 - weight) * from.root_position + weight * to.root_position;
  for (Role role : kRoles) {
    const Eigen::Quaternionf& p = from.rotation[role];
    const Eigen::Quaternionf& q = to.rotation[role];
    const Eigen::Quaternionf& p_at_start = from_at_start.rotation[role];
    const Eigen::Quaternionf& q_at_start = to_at_start.rotation[role];
    // The stored signs mean nothing, so each rotation takes the sign nearest to its own start.
    const float sign = shorter_sign(p, p_at_start) * shorter_sign(p_at_start, q_at_start) *
                       shorter_sign(q_at_start, q);
    result.rotation[role] =
        sign * p.dot(q) < kWholeTurn ? slerp(p, q, weight) : slerp_with_sign(p, q, sign, weight);
  }
  return result;
}

}  // namespace flinch::motion
