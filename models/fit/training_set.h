// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/clip_mask.h"

namespace flinch::models {

/// Labelled observations that a model is fitted to.
struct TrainingSet {
  int feature_count = 0;
  std::vector<double> points;  ///< row-major, scaled, one row of feature_count per observation
  std::vector<int> label;      ///< clip index, one per observation
  std::vector<int> mask;       ///< index into `masks`, one per observation
  /// Cost of each clip, N·s: row-major, one row per observation and one column per clip, infinity
  /// where the clip was not tried. Empty where no costs are known.
  std::vector<float> cost;
  /// What costs of an observation count by where they are compared with those of others, one per
  /// observation: twice as large costs with a unit of 2 count the same. Empty: 1.
  std::vector<float> unit;
  /// Which clips are allowed, by clip index: one mask per target.
  std::vector<ClipMask> masks;
  int idle = 0;  ///< the library's idle clip

  int size() const { return static_cast<int>(label.size()); }
  std::span<const double> point(int observation) const {
    const auto count = static_cast<std::size_t>(feature_count);
    return {points.data() + static_cast<std::size_t>(observation) * count, count};
  }
  /// Number of values in a row of `cost`.
  std::size_t clip_count() const { return masks.empty() ? 0 : masks.front().size(); }
  /// Costs of the clips for one observation. Requires known costs.
  std::span<const float> costs(int observation) const {
    return std::span(cost).subspan(static_cast<std::size_t>(observation) * clip_count(),
                                   clip_count());
  }
  float unit_of(int observation) const {
    return unit.empty() ? 1.0F : unit[static_cast<std::size_t>(observation)];
  }
  const ClipMask& allowed_clips(int observation) const {
    return masks[static_cast<std::size_t>(mask[static_cast<std::size_t>(observation)])];
  }
};

/// Throws Error unless there are at least two observations, sizes agree, every number is finite and
/// every observation's label is allowed by its mask.
void check(const TrainingSet& set);

/// Throws Error unless every observation has a clip whose cost is known, and no cost is negative or
/// NaN: what learning from costs requires beyond check().
void check_costs(const TrainingSet& set);

/// Returns the clips that were tried on any observation, ascending. The set must pass
/// check_costs().
std::vector<int> tried_clips(const TrainingSet& set);

/// Returns the observations with these indices, in this order.
TrainingSet subset(const TrainingSet& set, std::span<const int> observations);

}  // namespace flinch::models
