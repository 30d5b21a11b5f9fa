// SPDX-License-Identifier: MIT
#include "features/known_kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flinch::features {

KindNumbers numbers_of(const KnownKind& kind) {
  return {kind.radius_m.min,         kind.radius_m.max,       kind.mass_kg.min,
          kind.mass_kg.max,          kind.speed_mps.min,      kind.speed_mps.max,
          kind.elevation.min,        kind.elevation.max,      kind.time_to_impact_s.min,
          kind.time_to_impact_s.max, kind.bounce.restitution, kind.bounce.friction};
}

KnownKind kind_of(const std::string& name, const KindNumbers& numbers, bool falls) {
  const KindNumbers& n = numbers;
  return {name,
          {n[0], n[1]},
          {n[2], n[3]},
          {n[4], n[5]},
          {n[6], n[7]},
          {n[8], n[9]},
          {n[10], n[11]},
          falls,
          ThreatShape::ball,
          {},
          {}};
}

RodNumbers numbers_of(const RodRanges& rod) {
  return {rod.length_m.min, rod.length_m.max, rod.strikes_at.min, rod.strikes_at.max,
          rod.tilt.min,     rod.tilt.max,     rod.grip_share.min, rod.grip_share.max,
          rod.spin.min,     rod.spin.max,     rod.balance,        rod.grip_mass_kg};
}

RodRanges rod_ranges_of(const RodNumbers& numbers) {
  const RodNumbers& n = numbers;
  return {{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}, {n[8], n[9]}, n[10], n[11]};
}

Rod rod_of_kind(const KnownKind& kind, const Eigen::Vector3f& axis,
                const Eigen::Vector3f& angular_velocity, float to_butt_m, float to_tip_m) {
  Rod rod{axis, angular_velocity, to_butt_m, to_tip_m, 0, 0};
  if (!kind.is_driven()) return rod;
  rod.to_mass_m = static_cast<float>(kind.rod.balance) * (to_butt_m + to_tip_m) - to_butt_m;
  rod.grip_mass_kg = static_cast<float>(kind.rod.grip_mass_kg);
  return rod;
}

RodInertia largest_rod(const KnownKind& kind) {
  const auto length_m = static_cast<float>(kind.rod.length_m.max - 2 * kind.radius_m.min);
  const auto balance = static_cast<float>(kind.rod.balance);
  const float to_butt_m = kind.is_driven() ? 0 : balance * length_m;
  const Rod rod = rod_of_kind(kind, Eigen::Vector3f::UnitX(), Eigen::Vector3f::Zero(), to_butt_m,
                              length_m - to_butt_m);
  return inertia_of(rod, static_cast<float>(kind.radius_m.min),
                    static_cast<float>(kind.mass_kg.max));
}

namespace {

/// The largest mass with which a threat of a kind strikes.
double largest_mass_kg(const KnownKind& kind) {
  if (kind.shape != ThreatShape::rod) return kind.mass_kg.max;
  const RodInertia rod = largest_rod(kind);
  const double length_m = kind.rod.length_m.max - 2 * kind.radius_m.min;
  const double butt_m = kind.is_driven() ? 0 : kind.rod.balance * length_m;
  const double nearest_m = std::clamp(rod.to_mass_m, kind.rod.strikes_at.min * length_m - butt_m,
                                      kind.rod.strikes_at.max * length_m - butt_m);
  return rod.effective_mass_kg(nearest_m);
}

}  // namespace

double largest_impulse_ns(const KnownKind& kind) {
  return (1 + kind.bounce.restitution) * largest_mass_kg(kind) * kind.speed_mps.max;
}

namespace {

bool is_range_within(const ValueRange& range, double min, double max) {
  return range.min >= min && range.min <= range.max && range.max <= max;  // false for NaN
}

bool is_sound_rod(const KnownKind& kind) {
  constexpr double kMaxTurn = 1e3;  // rad/s
  const RodRanges& rod = kind.rod;
  const bool is_swung = kind.is_driven();
  return rod.length_m.min > 2 * kind.radius_m.max && rod.length_m.max <= double{kMaxRodLength_m} &&
         is_range_within(rod.strikes_at, 0, 1) && (!is_swung || rod.strikes_at.min > 0) &&
         is_range_within(rod.tilt, -2 * std::numbers::pi, 2 * std::numbers::pi) &&
         is_range_within(rod.grip_share, 0, 1) && is_range_within(rod.spin, 0, kMaxTurn) &&
         rod.balance >= 0 && rod.balance <= 1 && rod.grip_mass_kg >= 0 &&
         rod.grip_mass_kg <= (is_swung ? double{kMaxExtent} : 0);
}

}  // namespace

bool is_sound(const KnownKind& kind) {
  Threat threat;
  threat.bounce = kind.bounce;
  const auto is_range = [](const ValueRange& range) {
    return std::abs(range.min) <= double{kMaxExtent} && range.min <= range.max &&
           range.max <= double{kMaxExtent};  // false for NaN
  };
  const bool is_rod = kind.shape == ThreatShape::rod;
  const bool must_be_driven = kind.shape == ThreatShape::fist;
  const bool has_reach = kind.is_driven()
                             ? (must_be_driven || is_rod) && kind.reach_m.min > 0 && !kind.falls
                             : !must_be_driven && kind.reach_m == ValueRange{};
  const bool is_sound_shape =
      is_rod ? is_range(kind.rod.length_m) && is_sound_rod(kind) : kind.rod == RodRanges{};
  return kind.shape <= ThreatShape::rod && is_range(kind.reach_m) && has_reach && is_sound_shape &&
         is_usable(threat) && is_range(kind.radius_m) && is_range(kind.mass_kg) &&
         is_range(kind.speed_mps) && is_range(kind.elevation) && is_range(kind.time_to_impact_s);
}

}  // namespace flinch::features
