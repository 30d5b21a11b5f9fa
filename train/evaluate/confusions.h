// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// The test scenarios with one label for which a row chose one clip: a cell of its confusion
/// matrix.
struct ConfusionRow {
  std::string name;    ///< of the row
  std::string label;   ///< the clip of the lowest cost
  std::string chosen;  ///< the clip that the row chose
  std::size_t scenarios = 0;
  double mean_regret_ns = 0;
};

/// Returns the cells that have scenarios, of every row that looks at the threat: all except idle,
/// random and oracle. Cells are in the order of the clips in the library, by label, then by choice.
std::vector<ConfusionRow> confusion_rows(const TrainTestSplit& split, const Evaluation& evaluation);

}  // namespace flinch::train
