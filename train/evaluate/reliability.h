// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// What a row says of its choices against what came of them, for choices of like confidence.
struct ReliabilityBin {
  std::string name;      ///< of the row
  std::string said;      ///< "vote" or "expected_cost_ns"
  double mean_said = 0;  ///< of the chosen clips
  std::size_t scenarios = 0;
  double accuracy = 0;  ///< share whose label was chosen
  double mean_cost_ns = 0;
  double mean_regret_ns = 0;
};

/// Ten bins of equally many scenarios, by rising confidence, of every row that tells votes or
/// expected costs; fewer where there are fewer scenarios. Ties of confidence by scenario.
std::vector<ReliabilityBin> reliability(const Evaluation& evaluation);

}  // namespace flinch::train
