// SPDX-License-Identifier: MIT
#include "features/threat.h"

#include <cmath>

namespace flinch::features {
namespace {

const Eigen::Vector3f kFall(0, 0, -kGravity);

bool is_within_extent(const Eigen::Vector3f& vector) {
  return (vector.array().abs() <= kMaxExtent).all();  // false for NaN
}

bool is_within_extent(float number) {
  return number >= 0 && number <= kMaxExtent;  // false for NaN
}

}  // namespace

bool is_usable(const Threat& threat) {
  return is_within_extent(threat.position) && is_within_extent(threat.velocity) &&
         is_within_extent(threat.radius) && is_within_extent(threat.mass_kg);
}

Eigen::Vector3f position_at(const Threat& threat, float time_s) {
  return threat.position + time_s * threat.velocity + 0.5F * time_s * time_s * kFall;
}

Eigen::Vector3f velocity_at(const Threat& threat, float time_s) {
  return threat.velocity + time_s * kFall;
}

Threat advanced(const Threat& threat, float time_s) {
  Threat later = threat;
  later.position = position_at(threat, time_s);
  later.velocity = velocity_at(threat, time_s);
  return later;
}

// At the impact the threat is at p_T with v_T = -speed u, where u is the unit vector to where it
// comes from. Going back by T under the acceleration a = (0, 0, -g):
//   v_0 = v_T - a T,   p_0 = p_T - v_0 T - a T^2 / 2
Threat threat_from_description(const ThreatDescription& description,
                               const Eigen::Vector3f& impact_point, float facing) {
  const float yaw = facing + description.azimuth;
  const Eigen::Vector3f origin_direction(std::cos(description.elevation) * std::cos(yaw),
                                         std::cos(description.elevation) * std::sin(yaw),
                                         std::sin(description.elevation));
  const float time_s = description.time_to_impact_s;
  Threat threat;
  threat.velocity = -description.speed_mps * origin_direction - time_s * kFall;
  threat.position = impact_point - time_s * threat.velocity - 0.5F * time_s * time_s * kFall;
  threat.radius = description.radius;
  threat.mass_kg = description.mass_kg;
  return threat;
}

}  // namespace flinch::features
