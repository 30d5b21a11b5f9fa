// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "train/evaluate/intended_use.h"
#include "train/evaluate/split.h"
#include "train/objective/cost.h"

namespace flinch::train {

/// What the exhaustive choice does at one brawn, over the test scenarios. Shares are of all
/// choices.
struct BrawnRow {
  double brawn = 0;
  double mean_damage_ns = 0;  ///< that remains
  double mean_work_j = 0;
  /// Share of each kind of clip ("block", "duck", ...), and of the idle clip as "idle"; the same
  /// kinds in every row.
  std::map<std::string, double> kind;
  IntendedUse use;
};

/// Chooses at brawns from 0 to 1 from the same simulations. None if the store does not hold its
/// library, which knows the kinds.
std::vector<BrawnRow> brawn_rows(const TrainTestSplit& split, const CostModel& cost_model);

}  // namespace flinch::train
