// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// Number of sectors about the facing that threats are grouped by.
inline constexpr int kDirectionSectors = 12;

/// Results of one row on the test scenarios whose threats come from one sector and fly at one
/// target: a cell of a map.
struct DirectionRow {
  std::string target;
  int azimuth_degrees = 0;  ///< middle of the sector, in (-180, 180]; 90 is the character's left
  std::size_t scenarios = 0;
  std::string name;  ///< of the row
  double mean_cost_ns = 0;
  double regret_ns = 0;
  double protection = 0;  ///< not a number if idling is the best choice there
};

/// Returns the results of every row in every cell that has scenarios, by target, then by azimuth.
std::vector<DirectionRow> direction_rows(const TrainTestSplit& split, const Evaluation& evaluation);

}  // namespace flinch::train
