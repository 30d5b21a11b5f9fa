// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "features/threat.h"
#include "motion/rotation.h"

namespace flinch::features {

/// Numbers from `min` to `max`, both of them included; a single number if they are equal.
struct ValueRange {
  double min = 0;
  double max = 0;

  bool operator==(const ValueRange&) const = default;
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
  ValueRange reach_m{};  ///< how far a fist moves before the impact; 0 for other shapes

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

/// Returns the largest impulse that a threat of this kind can give, N·s: (1 + restitution) times
/// mass times speed.
double largest_impulse_ns(const KnownKind& kind);

/// Whether all numbers are finite and bounded, no range is the wrong way round, restitution is from
/// 0 to 1, friction at least 0, and the reach above 0 for a fist, which flies straight, and 0 for
/// others. Names are not checked.
bool is_sound(const KnownKind& kind);

}  // namespace flinch::features
