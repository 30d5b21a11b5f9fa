// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::train {

/// Share of the cost of staying idle that the exhaustive choice prevents, in one group of
/// scenarios.
struct PreventionRow {
  std::string group;  ///< "all", "target", "direction" or "time_to_impact"
  /// Name of the group's value, such as "head", "-45" (degrees) or "0.50 to 0.75" (s).
  std::string value;
  std::size_t scenarios = 0;
  double idle_cost_ns = 0;    ///< mean
  double oracle_cost_ns = 0;  ///< mean

  /// Returns 1 - oracle / idle; not a number if idling costs nothing.
  double prevented() const { return 1 - oracle_cost_ns / idle_cost_ns; }
};

/// A library is judged by threats that leave at least this long to respond, s.
inline constexpr float kMinAnswerTime_s = 0.5F;

/// Returns rows by target and by direction for the scenarios with at least kMinAnswerTime_s, and by
/// time to impact for all scenarios. Leaves out groups without scenarios. `labels` are those of the
/// store's observations.
std::vector<PreventionRow> prevention_rows(const Store& store, const Labels& labels);

}  // namespace flinch::train
