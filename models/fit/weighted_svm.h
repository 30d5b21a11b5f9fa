// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "features/random.h"

namespace flinch::models {

/// Explicit features, one row an observation.
using FeatureRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One example that a linear machine learns from.
struct WeightedExample {
  int row = 0;      ///< of the features
  float sign = 1;   ///< +1 or -1: which side it is to be on
  float bound = 1;  ///< C times its weight, above 0: what its hinge loss counts
};

struct DescentOptions {
  int pass_count = 30;     ///< over the examples, at the most
  float tolerance = 0.1F;  ///< of the projected gradients, largest minus least
};

/// A linear machine u without offset, which decides for +1 where u.x > 0.
struct LinearMachine {
  Eigen::VectorXf weights;         ///< u
  std::vector<float> multipliers;  ///< of each example, in [0, bound]
};

/// The machine that minimises |u|^2 / 2 + sum of bound max(0, 1 - sign u.x): a support vector
/// machine with a weight an example. Dual coordinate descent of Hsieh, Chang, Lin, Keerthi and
/// Sundararajan (2008), "A dual coordinate descent method for large-scale linear SVM", with their
/// shrinking; takes time and memory linear in the examples and features. Examples are visited in an
/// order drawn from `random`: same examples, same numbers, same bits. Rows are finite and not zero.
LinearMachine fit_weighted_svm(const FeatureRows& features,
                               std::span<const WeightedExample> examples,
                               const DescentOptions& limits, features::Random random);

}  // namespace flinch::models
