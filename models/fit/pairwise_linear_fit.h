// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "models/fit/training_set.h"
#include "models/pairwise_linear.h"

namespace flinch::models {

/// What pairwise machines are fitted with. Both are free of units: costs count in units of their
/// mean over all trials.
struct PairwiseParameters {
  double c = 3;           ///< how much an example weighs against a small machine
  double nearness = 0.1;  ///< how far above the least cost a pair's better clip still matters

  bool operator==(const PairwiseParameters&) const = default;
};

/// The parameters to choose from by cross-validation: C 1 and 3 with nearness 0.1, and C 1 with
/// nearness 0.2. Of C from 0.1 to 10 and nearness from 0.05 to 0.2, one of the first two was the
/// best on an authored library and on motion capture.
std::vector<PairwiseParameters> pairwise_grid();

/// Fits a machine to each pair of clips by dual coordinate descent (models/weighted_svm.h). Every
/// observation on which both were tried is an example of who was cheaper, weighted by
///   |cost_i - cost_j| exp(-(min(cost_i, cost_j) - least cost) / nearness):
/// what the wrong answer costs, times how likely the answer is to decide who is chosen. Takes time
/// linear in the observations. Pairs are fitted in parallel by OpenMP; the bits do not depend on
/// the number of threads. Throws Error for what check() refuses, for a set without costs, and for
/// parameters that are not above 0 and finite.
PairwiseModel fit_pairwise(const TrainingSet& set, const PairwiseParameters& parameters);

}  // namespace flinch::models
