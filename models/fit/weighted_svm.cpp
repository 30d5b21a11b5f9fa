// SPDX-License-Identifier: MIT
#include "models/fit/weighted_svm.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace flinch::models {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Minimum and maximum projected gradient of a pass.
struct GradientRange {
  float min = kInfinity;
  float max = -kInfinity;
};

// The dual problem: minimise |u|^2 / 2 - sum of a over the multipliers a in [0, bound], where u =
// sum of a sign x (Hsieh et al. 2008, equation 4). With the others fixed, the optimal multiplier of
// one example is known (equation 9):
//   G = sign u.x - 1,   a' = min(max(a - G / |x|^2, 0), bound),   u += (a' - a) sign x.
// The projected gradient is G, but 0 where a bound prevents the step; all are 0 at the optimum.
class Descent {
 public:
  Descent(const FeatureRows& features, std::span<const WeightedExample> examples,
          features::Random random, const Kernels& kernels)
      : features_(features),
        examples_(examples),
        random_(random),
        kernels_(kernels),
        order_(examples.size()),
        active_(examples.size()),
        weights_(features.row_size() / kKernelBlock),
        multipliers_(examples.size()) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  LinearMachine run(const DescentOptions& limits) {
    GradientRange last{-kInfinity, kInfinity};
    for (int pass = 0; pass < limits.pass_count; ++pass) {
      const GradientRange seen = visit_active(last);
      const bool is_settled = seen.max - seen.min <= limits.tolerance;
      if (is_settled && active_ == order_.size()) break;
      if (is_settled) {
        active_ = order_.size();
      }
      // Shrinking thresholds for the next pass (their section 3.2): none after a converged pass.
      last.max = is_settled || seen.max <= 0 ? kInfinity : seen.max;
      last.min = is_settled || seen.min >= 0 ? -kInfinity : seen.min;
    }
    return {Eigen::Map<const Eigen::VectorXf>(floats_of(weights_),
                                              static_cast<Eigen::Index>(features_.column_count())),
            std::move(multipliers_)};
  }

 private:
  /// Visits every active example once, in random order. Deactivates those whose gradient at a bound
  /// exceeds the range of the previous pass.
  GradientRange visit_active(const GradientRange& last) {
    random_.shuffle(std::span(order_).first(active_));
    GradientRange range;
    for (std::size_t place = 0; place < active_;) {
      fetch_row_of(order_[std::min(place + 1, active_ - 1)]);
      const auto example = static_cast<std::size_t>(order_[place]);
      const float gradient = gradient_of(example);
      const bool at_zero = multipliers_[example] <= 0;
      const bool at_bound = multipliers_[example] >= examples_[example].bound;
      if ((at_zero && gradient > last.max) || (at_bound && gradient < last.min)) {
        std::swap(order_[place], order_[--active_]);
        continue;
      }
      const bool is_held = (at_zero && gradient > 0) || (at_bound && gradient < 0);
      range.min = std::min(range.min, is_held ? 0.0F : gradient);
      range.max = std::max(range.max, is_held ? 0.0F : gradient);
      if (!is_held) {
        step(example, gradient);
      }
      ++place;
    }
    return range;
  }

  /// The rows of all examples exceed the cache, and are read in random order: the next one is
  /// fetched while the current one is computed with.
  void fetch_row_of(int example) const {
    const float* next = features_.row(examples_[static_cast<std::size_t>(example)].row);
    for (std::size_t i = 0; i < features_.row_size(); i += kKernelBlock)
      __builtin_prefetch(next + i);
  }

  float gradient_of(std::size_t example) {
    const WeightedExample& one = examples_[example];
    return one.sign *
               kernels_.dot(features_.row_size(), features_.row(one.row), floats_of(weights_)) -
           1;
  }

  void step(std::size_t example, float gradient) {
    const WeightedExample& one = examples_[example];
    float& multiplier = multipliers_[example];
    const float before = multiplier;
    multiplier = std::clamp(before - gradient / features_.squared_norm(one.row), 0.0F, one.bound);
    kernels_.add_scaled(features_.row_size(), (multiplier - before) * one.sign,
                        features_.row(one.row), floats_of(weights_));
  }

  const FeatureRows& features_;
  std::span<const WeightedExample> examples_;
  features::Random random_;
  const Kernels& kernels_;
  std::vector<int> order_;  ///< of the examples, the active ones first
  std::size_t active_;
  std::vector<KernelBlock> weights_;
  std::vector<float> multipliers_;
};

}  // namespace

FeatureRows::FeatureRows(std::size_t row_count, std::size_t column_count)
    : column_count_(column_count),
      row_size_((column_count + kKernelBlock - 1) / kKernelBlock * kKernelBlock),
      blocks_(row_count * row_size_ / kKernelBlock),
      squared_norm_(row_count) {}

void FeatureRows::set_row(std::size_t row, std::span<const float> values) {
  float* to = floats_of(blocks_) + row * row_size_;
  std::copy(values.begin(), values.end(), to);
  squared_norm_[row] = widest_kernels().dot(row_size_, to, to);
}

LinearMachine fit_weighted_svm(const FeatureRows& features,
                               std::span<const WeightedExample> examples,
                               const DescentOptions& limits, features::Random random,
                               const Kernels& kernels) {
  return Descent(features, examples, random, kernels).run(limits);
}

}  // namespace flinch::models
