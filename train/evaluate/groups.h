// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// Results of one row on a group of the test scenarios.
struct GroupRow {
  std::string
      group;  ///< "kind", "stance", "target", "speed_mps" (at the impact) or "time_to_impact_s"
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

/// Protection of one row against one kind of threat.
struct KindRow {
  std::string kind;
  std::size_t scenarios = 0;
  double idle_cost_ns = 0;    ///< mean over its scenarios
  double oracle_cost_ns = 0;  ///< mean over its scenarios
  std::string name;           ///< of the row
  Estimate protection;
};

/// Returns the results of every method, alone and looking ahead, against every kind of threat that
/// has scenarios; none where there is one kind. `seed` seeds the resamples.
std::vector<KindRow> kind_rows(const TrainTestSplit& split, const Evaluation& evaluation,
                               std::uint64_t seed);

}  // namespace flinch::train
