// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/svm_fit.h"

namespace flinch::models {

/// Throws Error with what libsvm has against the parameters, and for numbers that are not finite.
void check(const SvmParameters& parameters);

/// Two classes as libsvm is given them.
struct PairProblem {
  std::span<const double> first;   ///< rows of feature_count values, an observation each
  std::span<const double> second;  ///< the same of the other class
  int feature_count = 0;
  double first_weight = 1;  ///< of C
  double second_weight = 1;
};

/// What libsvm finds of two classes.
struct PairSolution {
  std::vector<double> coefficients;  ///< not negative, one an observation: first's, then second's
  double rho = 0;
};

/// libsvm's solution, to the bit what svm_train finds for this pair among any number of classes: it
/// solves a pair on the observations of both, first's before second's.
PairSolution fit_pair(const PairProblem& problem, const SvmParameters& parameters);

}  // namespace flinch::models
