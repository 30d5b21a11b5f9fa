// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "features/random.h"

namespace flinch::models {

/// Explicit features, one row per observation.
using FeatureRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One training example of a linear machine.
struct WeightedExample {
  int row = 0;      ///< index into the features
  float sign = 1;   ///< +1 or -1: the class
  float bound = 1;  ///< C times the example's weight, above 0: the factor of its hinge loss
};

struct DescentOptions {
  int pass_count = 30;     ///< maximum number of passes over the examples
  float tolerance = 0.1F;  ///< on the range of projected gradients, maximum minus minimum
};

/// A linear machine u without offset, which votes for +1 where u.x > 0.
struct LinearMachine {
  Eigen::VectorXf weights;         ///< u
  std::vector<float> multipliers;  ///< dual variable of each example, in [0, bound]
};

/// Returns the machine that minimises |u|^2 / 2 + sum of bound max(0, 1 - sign u.x): a support
/// vector machine with one weight per example. Uses the dual coordinate descent of Hsieh, Chang,
/// Lin, Keerthi and Sundararajan (2008), "A dual coordinate descent method for large-scale linear
/// SVM", with their shrinking. Takes time and memory linear in the examples and features. The order
/// of examples is drawn from `random`: same examples, same numbers, same bits. Rows must be finite
/// and not zero.
LinearMachine fit_weighted_svm(const FeatureRows& features,
                               std::span<const WeightedExample> examples,
                               const DescentOptions& limits, features::Random random);

}  // namespace flinch::models
