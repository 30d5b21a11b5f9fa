// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// Results of one row on a group of the test scenarios.
struct GroupRow {
  std::string group;  ///< "kind", "target", "speed_mps" (at the impact) or "time_to_impact_s"
  std::string value;  ///< name of the group's value, such as "head" or "0.50 to 0.75"
  std::size_t scenarios = 0;
  std::string name;  ///< of the row
  Estimate mean_cost_ns;
  Estimate regret_ns;
  Estimate protection;
};

/// Returns the results of every row in every group that has scenarios, with intervals over the
/// group's own scenarios. `seed` seeds the resamples.
std::vector<GroupRow> group_rows(const TrainTestSplit& split, const Evaluation& evaluation,
                                 std::uint64_t seed);

}  // namespace flinch::train
