// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "features/random.h"
#include "models/fit/kernels.h"

namespace flinch::models {

/// Explicit features, one row per observation, which zeros fill up to whole blocks of the kernels.
class FeatureRows {
 public:
  /// All features are 0.
  FeatureRows(std::size_t row_count, std::size_t column_count);

  /// `values` has column_count() values.
  void set_row(std::size_t row, std::span<const float> values);

  std::size_t column_count() const { return column_count_; }
  /// Number of floats in a row, zeros included: a multiple of kKernelBlock.
  std::size_t row_size() const { return row_size_; }
  const float* row(std::size_t row) const { return floats_of(blocks_) + row * row_size_; }
  float squared_norm(std::size_t row) const { return squared_norm_[row]; }

 private:
  std::size_t column_count_;
  std::size_t row_size_;
  std::vector<KernelBlock> blocks_;
  std::vector<float> squared_norm_;
};

/// One training example of a linear machine.
struct WeightedExample {
  std::size_t row = 0;  ///< index into the features
  float sign = 1;       ///< +1 or -1: the class
  float bound = 1;      ///< C times the example's weight, above 0: the factor of its hinge loss
};

struct DescentOptions {
  int pass_count = 30;  ///< maximum number of passes over the examples
  /// Stops once the objective is shown to be at most this share above its minimum.
  double tolerance = 0.02;
};

/// A linear machine u without offset, which votes for +1 where u.x > 0.
struct LinearMachine {
  Eigen::VectorXf weights;         ///< u, one weight per column
  std::vector<float> multipliers;  ///< dual variable of each example, in [0, bound]
  bool is_converged = false;       ///< false: the passes ended before the tolerance was reached
};

/// Returns the machine that minimises |u|^2 / 2 + sum of bound max(0, 1 - sign u.x): a support
/// vector machine with one weight per example. Uses the dual coordinate descent of Hsieh, Chang,
/// Lin, Keerthi and Sundararajan (2008), "A dual coordinate descent method for large-scale linear
/// SVM", with their shrinking. Takes time and memory linear in the examples and features. The order
/// of examples is drawn from `random`; no pass lowers the dual objective, but for rounding, and a
/// converged machine's objective is at most `tolerance` above the minimum, by its duality gap: same
/// examples, same numbers, same bits, whatever the kernels. Rows must be finite and not zero.
LinearMachine fit_weighted_svm(const FeatureRows& features,
                               std::span<const WeightedExample> examples,
                               const DescentOptions& limits, features::Random random,
                               const Kernels& kernels = widest_kernels());

}  // namespace flinch::models
