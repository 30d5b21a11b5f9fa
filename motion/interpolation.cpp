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

// q and -q are the same rotation: returns the sign of `to` that gives the shorter arc.
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

Signs shorter_arcs(const Pose& from, const Pose& to) {
  Signs signs;
  for (Role role : kRoles) signs[role] = shorter_sign(from.rotation[role], to.rotation[role]);
  return signs;
}

void change_signs(const Pose& a, const Pose& b, std::span<const Role> roles, Signs& signs) {
  for (Role role : roles) signs[role] *= shorter_sign(a.rotation[role], b.rotation[role]);
}

Pose blend_along(const Pose& from, const Pose& to, float weight, const Signs& signs,
                 std::span<const Role> roles) {
  // cosine of half the arc; below it the arc's direction is undefined
  constexpr float kWholeTurn = -0.95F;
  Pose result;
  result.root_position = (1 - weight) * from.root_position + weight * to.root_position;
  for (Role role : roles) {
    const Eigen::Quaternionf& p = from.rotation[role];
    const Eigen::Quaternionf& q = to.rotation[role];
    result.rotation[role] = signs[role] * p.dot(q) < kWholeTurn
                                ? slerp(p, q, weight)
                                : slerp_with_sign(p, q, signs[role], weight);
  }
  return result;
}

// Stored signs are arbitrary, so each rotation takes the sign that is nearest to its own start.
Pose blend_along_initial_arc(const Pose& from, const Pose& to, float weight,
                             const Pose& from_at_start, const Pose& to_at_start) {
  Signs signs = shorter_arcs(from_at_start, to_at_start);
  change_signs(from, from_at_start, kRoles, signs);
  change_signs(to, to_at_start, kRoles, signs);
  return blend_along(from, to, weight, signs);
}

}  // namespace flinch::motion
