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
          features::Random random)
      : features_(features),
        examples_(examples),
        random_(random),
        order_(examples.size()),
        active_(examples.size()),
        machine_{Eigen::VectorXf::Zero(features.cols()), std::vector<float>(examples.size())} {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (const WeightedExample& one : examples) {
      squared_norm_.push_back(features.row(one.row).squaredNorm());
    }
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
    return std::move(machine_);
  }

 private:
  /// Visits every active example once, in random order. Deactivates those whose gradient at a bound
  /// exceeds the range of the previous pass.
  GradientRange visit_active(const GradientRange& last) {
    GradientRange range;
    for (std::size_t place = 0; place < active_;) {
      std::swap(order_[place], order_[place + random_.index(active_ - place)]);
      const std::size_t example = order_[place];
      const float gradient = gradient_of(example);
      const bool at_zero = machine_.multipliers[example] <= 0;
      const bool at_bound = machine_.multipliers[example] >= examples_[example].bound;
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

  float gradient_of(std::size_t example) const {
    const WeightedExample& one = examples_[example];
    return one.sign * features_.row(one.row).dot(machine_.weights) - 1;
  }

  void step(std::size_t example, float gradient) {
    const WeightedExample& one = examples_[example];
    float& multiplier = machine_.multipliers[example];
    const float before = multiplier;
    multiplier = std::clamp(before - gradient / squared_norm_[example], 0.0F, one.bound);
    machine_.weights += (multiplier - before) * one.sign * features_.row(one.row).transpose();
  }

  const FeatureRows& features_;
  std::span<const WeightedExample> examples_;
  features::Random random_;
  std::vector<std::size_t> order_;  ///< of the examples, the active ones first
  std::size_t active_;
  std::vector<float> squared_norm_;  ///< of each example's row
  LinearMachine machine_;
};

}  // namespace

LinearMachine fit_weighted_svm(const FeatureRows& features,
                               std::span<const WeightedExample> examples,
                               const DescentOptions& limits, features::Random random) {
  return Descent(features, examples, random).run(limits);
}

}  // namespace flinch::models
