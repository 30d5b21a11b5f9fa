// SPDX-License-Identifier: MIT
#include "features/known_kind.h"

#include <cmath>

namespace flinch::features {

KindNumbers numbers_of(const KnownKind& kind) {
  return {kind.radius_m.min,         kind.radius_m.max,       kind.mass_kg.min,
          kind.mass_kg.max,          kind.speed_mps.min,      kind.speed_mps.max,
          kind.elevation.min,        kind.elevation.max,      kind.time_to_impact_s.min,
          kind.time_to_impact_s.max, kind.bounce.restitution, kind.bounce.friction};
}

KnownKind kind_of(const std::string& name, const KindNumbers& numbers, bool falls) {
  const KindNumbers& n = numbers;
  return {name,         {n[0], n[1]},   {n[2], n[3]}, {n[4], n[5]},      {n[6], n[7]},
          {n[8], n[9]}, {n[10], n[11]}, falls,        ThreatShape::ball, {}};
}

double largest_impulse_ns(const KnownKind& kind) {
  return (1 + kind.bounce.restitution) * kind.mass_kg.max * kind.speed_mps.max;
}

bool is_sound(const KnownKind& kind) {
  Threat threat;
  threat.bounce = kind.bounce;
  const auto is_range = [](const ValueRange& range) {
    return std::abs(range.min) <= double{kMaxExtent} && range.min <= range.max &&
           range.max <= double{kMaxExtent};  // false for NaN
  };
  const bool is_fist = kind.shape == ThreatShape::fist;
  const bool has_reach = is_range(kind.reach_m) && (is_fist ? kind.reach_m.min > 0 && !kind.falls
                                                            : kind.reach_m == ValueRange{});
  return kind.shape <= ThreatShape::fist && has_reach && is_usable(threat) &&
         is_range(kind.radius_m) && is_range(kind.mass_kg) && is_range(kind.speed_mps) &&
         is_range(kind.elevation) && is_range(kind.time_to_impact_s);
}

}  // namespace flinch::features
