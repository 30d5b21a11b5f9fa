// SPDX-License-Identifier: MIT
#include "features/threat.h"

#include <algorithm>
#include <cmath>

#include "motion/enum_array.h"

namespace flinch::features {
namespace {

Eigen::Vector3f acceleration_of(bool falls) {
  return {0, 0, falls ? -kGravity : 0.0F};
}

Eigen::Vector3f acceleration_of(const Threat& threat) {
  return acceleration_of(threat.falls && !threat.stroke);
}

/// For how long a threat will have moved by then.
float moved_s(const Threat& threat, float time_s) {
  if (!threat.stroke) return time_s;
  return std::clamp(time_s - threat.stroke->starts_in_s, 0.0F, threat.stroke->lasts_s);
}

bool is_within_extent(const Eigen::Vector3f& vector) {
  return (vector.array().abs() <= kMaxExtent).all();  // false for NaN
}

constexpr motion::EnumArray<ThreatShape, std::string_view, 3> kShapeNames{"ball", "blade", "fist"};

bool is_within_extent(float number) {
  return number >= 0 && number <= kMaxExtent;  // false for NaN
}

}  // namespace

std::string_view name_of(ThreatShape shape) {
  return kShapeNames[shape];
}

std::optional<ThreatShape> threat_shape_named(std::string_view name) {
  const auto found = std::ranges::find(kShapeNames, name);
  if (found == kShapeNames.end()) return std::nullopt;
  return static_cast<ThreatShape>(found - kShapeNames.begin());
}

bool is_usable(const Threat& threat) {
  return is_within_extent(threat.position) && is_within_extent(threat.velocity) &&
         is_within_extent(threat.radius) && is_within_extent(threat.mass_kg) &&
         threat.bounce.restitution >= 0 && threat.bounce.restitution <= 1 &&
         threat.bounce.friction >= 0 && threat.bounce.friction <= double{kMaxExtent} &&
         threat.kind >= 0 &&
         (!threat.stroke || (is_within_extent(threat.stroke->starts_in_s) &&
                             is_within_extent(threat.stroke->lasts_s)));
}

Eigen::Vector3f position_at(const Threat& threat, float time_s) {
  const float t = moved_s(threat, time_s);
  return threat.position + t * threat.velocity + 0.5F * t * t * acceleration_of(threat);
}

Eigen::Vector3f velocity_at(const Threat& threat, float time_s) {
  return threat.velocity + time_s * acceleration_of(threat);
}

Threat advanced(const Threat& threat, float time_s) {
  Threat later = threat;
  later.position = position_at(threat, time_s);
  later.velocity = velocity_at(threat, time_s);
  if (threat.stroke) {
    later.stroke->starts_in_s = std::max(threat.stroke->starts_in_s - time_s, 0.0F);
    later.stroke->lasts_s = threat.stroke->lasts_s - moved_s(threat, time_s);
  }
  return later;
}

// At the impact the threat is at p_T with v_T = -speed u, where u is the unit vector to where it
// comes from. Going back by T under the acceleration a, which is (0, 0, -g) or 0:
//   v_0 = v_T - a T,   p_0 = p_T - v_0 T - a T^2 / 2
//
// A stroke moves for only the last part of T, and without acceleration.
Threat threat_from_description(const ThreatDescription& description,
                               const Eigen::Vector3f& impact_point, float facing) {
  const float yaw = facing + description.azimuth;
  const Eigen::Vector3f origin_direction(std::cos(description.elevation) * std::cos(yaw),
                                         std::cos(description.elevation) * std::sin(yaw),
                                         std::sin(description.elevation));
  Threat threat;
  float time_s = description.time_to_impact_s;
  if (description.reach_m) {
    const float lasts_s = std::min(*description.reach_m / description.speed_mps, time_s);
    threat.stroke = {time_s - lasts_s, lasts_s};
    time_s = lasts_s;
  }
  const Eigen::Vector3f acceleration = acceleration_of(description.falls && !threat.stroke);
  threat.velocity = -description.speed_mps * origin_direction - time_s * acceleration;
  threat.position = impact_point - time_s * threat.velocity - 0.5F * time_s * time_s * acceleration;
  threat.radius = description.radius;
  threat.mass_kg = description.mass_kg;
  threat.bounce = description.bounce;
  threat.falls = description.falls;
  threat.kind = description.kind;
  return threat;
}

}  // namespace flinch::features
