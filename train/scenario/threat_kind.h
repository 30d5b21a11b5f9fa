// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <vector>

#include "features/known_kind.h"
#include "motion/clip.h"

namespace flinch::train {

using features::ValueRange;

/// One kind of threat that scenarios are drawn with; its numbers are uniform in their ranges. By
/// default it comes from any direction. Angles in radians.
struct ThreatKind : features::KnownKind {
  double weight = 1;  ///< share of scenarios, relative to the other kinds
  /// Sectors that it comes from, counter-clockwise from the facing; together they are uniform.
  std::vector<ValueRange> azimuth = std::vector(1, ValueRange{-std::numbers::pi, std::numbers::pi});
  motion::PerTarget<double> target_weight{1, 1, 1, 1};  ///< how often each target is aimed at
  /// Threats aim at a point drawn uniformly from a ball of this radius about the target's centre.
  /// This is about the half-width of a head or a thigh, so that some threats graze and some miss.
  double aim_radius_m = 0.1;

  bool operator==(const ThreatKind&) const = default;
};

}  // namespace flinch::train
