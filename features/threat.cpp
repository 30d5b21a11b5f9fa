// SPDX-License-Identifier: MIT
#include "features/threat.h"

#include <cmath>

namespace flinch::features {
namespace {

Eigen::Vector3f acceleration_of(bool falls) {
  return {0, 0, falls ? -kGravity : 0.0F};
}

bool is_within_extent(const Eigen::Vector3f& vector) {
  return (vector.array().abs() <= kMaxExtent).all();  // false for NaN
}

bool is_within_extent(float number) {
  return number >= 0 && number <= kMaxExtent;  // false for NaN
}

}  // namespace

bool is_usable(const Threat& threat) {
  return is_within_extent(threat.position) && is_within_extent(threat.velocity) &&
         is_within_extent(threat.radius) && is_within_extent(threat.mass_kg) &&
         threat.bounce.restitution >= 0 && threat.bounce.restitution <= 1 &&
         threat.bounce.friction >= 0 && threat.bounce.friction <= double{kMaxExtent} &&
         threat.kind >= 0;
}

Eigen::Vector3f position_at(const Threat& threat, float time_s) {
  return threat.position + time_s * threat.velocity +
         0.5F * time_s * time_s * acceleration_of(threat.falls);
}

Eigen::Vector3f velocity_at(const Threat& threat, float time_s) {
  return threat.velocity + time_s * acceleration_of(threat.falls);
}

Threat advanced(const Threat& threat, float time_s) {
  Threat later = threat;
  later.position = position_at(threat, time_s);
  later.velocity = velocity_at(threat, time_s);
  return later;
}

// At the impact the threat is at p_T with v_T = -speed u, where u is the unit vector to where it
// comes from. Going back by T under the acceleration a, which is (0, 0, -g) or 0:
//   v_0 = v_T - a T,   p_0 = p_T - v_0 T - a T^2 / 2
Threat threat_from_description(const ThreatDescription& description,
                               const Eigen::Vector3f& impact_point, float facing) {
  const float yaw = facing + description.azimuth;
  const Eigen::Vector3f origin_direction(std::cos(description.elevation) * std::cos(yaw),
                                         std::cos(description.elevation) * std::sin(yaw),
                                         std::sin(description.elevation));
  const float time_s = description.time_to_impact_s;
  const Eigen::Vector3f acceleration = acceleration_of(description.falls);
  Threat threat;
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
