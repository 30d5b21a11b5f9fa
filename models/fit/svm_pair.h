// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/svm_fit.h"

namespace flinch::models {

/// Throws Error with libsvm's objection to the parameters, and for numbers that are not finite.
void check(const SvmParameters& parameters);

/// The training problem of two classes, in libsvm's terms.
struct PairProblem {
  std::span<const double> first;   ///< rows of feature_count values, one per observation
  std::span<const double> second;  ///< the same for the other class
  int feature_count = 0;
  double first_weight = 1;  ///< factor of C
  double second_weight = 1;
};

/// libsvm's solution for two classes.
struct PairSolution {
  std::vector<double> coefficients;  ///< not negative, one per observation: first's, then second's
  double rho = 0;
};

/// Returns libsvm's solution: to the bit what svm_train finds for this pair among any number of
/// classes, since it solves each pair on the observations of both, first's before second's.
PairSolution fit_pair(const PairProblem& problem, const SvmParameters& parameters);

}  // namespace flinch::models
