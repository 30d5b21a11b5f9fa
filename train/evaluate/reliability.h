// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// Predicted and actual results of a row's choices, for choices of similar confidence.
struct ReliabilityBin {
  std::string name;      ///< of the row
  std::string said;      ///< "vote" or "expected_cost_ns"
  double mean_said = 0;  ///< prediction, over the chosen clips
  std::size_t scenarios = 0;
  double accuracy = 0;  ///< share whose label was chosen
  double mean_cost_ns = 0;
  double mean_regret_ns = 0;
};

/// Returns ten bins of equally many scenarios, by ascending confidence, for each row that predicts
/// votes or expected costs; fewer bins if there are fewer scenarios. Ties of confidence are in the
/// order of the scenarios.
std::vector<ReliabilityBin> reliability(const Evaluation& evaluation);

}  // namespace flinch::train
