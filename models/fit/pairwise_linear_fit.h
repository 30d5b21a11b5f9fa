// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "models/fit/kernels.h"
#include "models/fit/training_set.h"
#include "models/pairwise_linear.h"

namespace flinch::models {

/// Parameters of fitting pairwise machines. Both are dimensionless: costs are divided by their mean
/// over all trials.
struct PairwiseParameters {
  double c = 3;           ///< weight of examples against the norm of the machine
  double nearness = 0.1;  ///< how far above the lowest cost a pair's better clip still matters

  bool operator==(const PairwiseParameters&) const = default;
};

/// Returns the parameters for cross-validation: C 1 and 3 with nearness 0.1, and C 1 with nearness
/// 0.2. Of C from 0.1 to 10 and nearness from 0.05 to 0.2, one of the first two was the best on an
/// authored library and on motion capture.
std::vector<PairwiseParameters> pairwise_grid();

/// Fits one machine per pair of clips by dual coordinate descent (models/fit/weighted_svm.h). Every
/// observation on which both clips were tried is an example of which one was cheaper, with the
/// weight
///   |cost_i - cost_j| exp(-(min(cost_i, cost_j) - least cost) / nearness):
/// the cost of the wrong answer, times how likely the answer is to decide the choice. Takes time
/// linear in the number of observations. Pairs are fitted in parallel by OpenMP; the bits do not
/// depend on the number of threads. Throws Error for a set that check() rejects, for a set without
/// costs, and for parameters that are not positive and finite.
PairwiseModel fit_pairwise(const TrainingSet& set, const PairwiseParameters& parameters,
                           const Kernels& kernels = widest_kernels());

}  // namespace flinch::models
