// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "features/threat.h"
#include "motion/body.h"
#include "motion/rotation.h"

namespace flinch::features {

/// Numbers from `min` to `max`, both of them included; a single number if they are equal.
struct ValueRange {
  double min = 0;
  double max = 0;

  bool operator==(const ValueRange&) const = default;
};

/// What makes a kind one of rods, and the ranges of its numbers; all 0 for other shapes.
struct RodRanges {
  ValueRange length_m{};    ///< from end to end
  ValueRange strikes_at{};  ///< share of the length from the butt to the point that strikes
  ValueRange tilt{};        ///< see RodDescription
  ValueRange grip_share{};  ///< see RodDescription
  ValueRange spin{};        ///< of one that is thrown, rad/s
  double balance = 0;       ///< share of the length from the butt to the centre of mass
  double grip_mass_kg = 0;  ///< effective mass of the hands that swing it

  bool operator==(const RodRanges&) const = default;
};

/// A kind of threats that a store or a selector knows, and the ranges of its numbers. The defaults
/// are a volleyball thrown or spiked. Angles in radians.
struct KnownKind {
  std::string name = "volleyball";
  ValueRange radius_m{kVolleyballRadius_m, kVolleyballRadius_m};
  ValueRange mass_kg{kVolleyballMass_kg, kVolleyballMass_kg};
  ValueRange speed_mps{8, 30};                                          ///< at the impact
  ValueRange elevation{motion::radians(-10.0), motion::radians(45.0)};  ///< at the impact
  ValueRange time_to_impact_s{0.25, 1.2};                               ///< from perception
  Bounce bounce{};
  bool falls = true;  ///< or flies straight
  ThreatShape shape = ThreatShape::ball;
  /// How far a fist, or the point of a swung rod that strikes, moves before the impact; 0 for
  /// others.
  ValueRange reach_m{};
  RodRanges rod{};

  /// Whether it is driven along a stroke: a fist, or a rod that is swung.
  bool is_driven() const { return reach_m.max > 0; }
  bool operator==(const KnownKind&) const = default;
};

/// Largest number of kinds in a store or a selector.
inline constexpr std::size_t kMaxThreatKinds = 16;

/// The numbers of a kind in the order in which files hold them: the ends of its ranges, in the
/// order of the struct, then restitution and friction.
using KindNumbers = std::array<double, 12>;
KindNumbers numbers_of(const KnownKind& kind);
/// Returns a ball with these numbers.
KnownKind kind_of(const std::string& name, const KindNumbers& numbers, bool falls);

/// The numbers of a rod in the order in which files hold them: the ends of its ranges, in the order
/// of the struct, then balance and the mass at the grip.
using RodNumbers = std::array<double, 12>;
RodNumbers numbers_of(const RodRanges& rod);
RodRanges rod_ranges_of(const RodNumbers& numbers);

/// A rod of the kind as it is now: its axis and turn, and from its position to its ends. Balance
/// and the hands' mass are the kind's.
Rod rod_of_kind(const KnownKind& kind, const Eigen::Vector3f& axis,
                const Eigen::Vector3f& angular_velocity, float to_butt_m, float to_tip_m);

/// The masses of a rod of the kind that is as long and heavy as it may be.
RodInertia largest_rod(const KnownKind& kind);

/// Returns the largest impulse that a threat of this kind can give, N·s: (1 + restitution) times
/// mass times speed; of a rod with its effective mass where that is largest among the points that
/// strike.
double largest_impulse_ns(const KnownKind& kind);

/// How much an impulse on each body hurts, v_b, if a threat of this kind gives it.
struct KindVulnerability {
  int kind = 0;
  motion::PerBody<double> vulnerability{};

  bool operator==(const KindVulnerability& other) const {
    return kind == other.kind && vulnerability == other.vulnerability;
  }
};

/// Whether all numbers are finite and bounded, no range is the wrong way round, restitution is from
/// 0 to 1, friction at least 0, and the reach above 0 for a fist, which flies straight, and 0 for
/// others that are not rods; and a rod is longer than it is thick and at most kMaxRodLength_m.
/// Names are not checked.
bool is_sound(const KnownKind& kind);

}  // namespace flinch::features
