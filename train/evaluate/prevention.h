// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::train {

/// How much of the cost of staying idle the exhaustive choice prevents in some scenarios.
struct PreventionRow {
  std::string group;  ///< "all", "target", "direction" or "time_to_impact"
  std::string value;  ///< which of the group, such as "head", "-45" (degrees) or "0.50 to 0.75" (s)
  std::size_t scenarios = 0;
  double idle_cost_ns = 0;    ///< mean
  double oracle_cost_ns = 0;  ///< mean

  /// 1 - oracle / idle; not a number where idling costs nothing.
  double prevented() const { return 1 - oracle_cost_ns / idle_cost_ns; }
};

/// Threats that leave at least this long to answer are what a library is judged by, s.
inline constexpr float kMinAnswerTime_s = 0.5F;

/// By target and by direction among the scenarios with kMinAnswerTime_s or more, and by time to
/// impact among all. Groups without scenarios are left out. `labels` are those of the store's
/// observations.
std::vector<PreventionRow> prevention_rows(const Store& store, const Labels& labels);

}  // namespace flinch::train
