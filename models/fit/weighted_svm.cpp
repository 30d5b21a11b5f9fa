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

/// What a pass saw, before each of its steps.
struct Seen {
  float min_gradient = kInfinity;  ///< projected
  float max_gradient = -kInfinity;
  double gap = 0;  ///< sum of the examples' terms of the duality gap
};

// The dual problem: maximise D(a) = sum of a - |u|^2 / 2 over the multipliers a in [0, bound],
// where u = sum of a sign x (Hsieh et al. 2008, equation 4). With the others fixed, the optimal
// multiplier of one example is known (equation 9), so that no step lowers D:
//   G = sign u.x - 1,   a' = min(max(a - G / |x|^2, 0), bound),   u += (a' - a) sign x.
// The projected gradient is G, but 0 where a bound prevents the step; all are 0 at the optimum.
//
// The duality gap. With P(u) = |u|^2 / 2 + sum of bound max(0, -G), the objective, and
// |u|^2 = sum of a sign u.x = sum of a (G + 1),
//   P(u) - D(a) = sum of (a G + bound max(0, -G)) = sum of max(a G, (a - bound) G).
// Each term is at least 0, at most bound |G|, and 0 where the projected gradient is 0: the gap is
// at most the largest projected gradient times the sum of bounds. As D(a) <= min P <= P(u), a gap
// of at most t D(a) proves P(u) <= (1 + t) min P.
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
    Seen last{.min_gradient = -kInfinity, .max_gradient = kInfinity};
    bool is_converged = false;
    for (int pass = 0; pass < limits.pass_count; ++pass) {
      Seen seen = visit_active(last);
      const bool is_settled = seen.gap <= limits.tolerance * dual();
      if (is_settled) {
        is_converged = gap() <= limits.tolerance * dual();
        if (is_converged) break;
        active_ = order_.size();
      }
      // Shrinking thresholds for the next pass (their section 3.2): none after a settled pass.
      last.max_gradient = is_settled || seen.max_gradient <= 0 ? kInfinity : seen.max_gradient;
      last.min_gradient = is_settled || seen.min_gradient >= 0 ? -kInfinity : seen.min_gradient;
    }
    return {Eigen::Map<const Eigen::VectorXf>(floats_of(weights_),
                                              static_cast<Eigen::Index>(features_.column_count())),
            std::move(multipliers_), is_converged};
  }

 private:
  /// Visits every active example once, in random order. Deactivates those whose gradient at a bound
  /// exceeds the range of the previous pass.
  Seen visit_active(const Seen& last) {
    random_.shuffle(std::span(order_).first(active_));
    Seen seen;
    for (std::size_t place = 0; place < active_;) {
      fetch_row_of(order_[std::min(place + 1, active_ - 1)]);
      const auto example = static_cast<std::size_t>(order_[place]);
      const float gradient = gradient_of(example);
      const bool at_zero = multipliers_[example] <= 0;
      const bool at_bound = multipliers_[example] >= examples_[example].bound;
      if ((at_zero && gradient > last.max_gradient) || (at_bound && gradient < last.min_gradient)) {
        std::swap(order_[place], order_[--active_]);
        continue;
      }
      const bool is_held = (at_zero && gradient > 0) || (at_bound && gradient < 0);
      seen.min_gradient = std::min(seen.min_gradient, is_held ? 0.0F : gradient);
      seen.max_gradient = std::max(seen.max_gradient, is_held ? 0.0F : gradient);
      if (!is_held) {
        seen.gap += gap_term(example, gradient);
        step(example, gradient);
      }
      ++place;
    }
    return seen;
  }

  /// D(a).
  double dual() const {
    const float* u = floats_of(weights_);
    return multiplier_sum_ - double{kernels_.dot(features_.row_size(), u, u)} / 2;
  }

  double gap_term(std::size_t example, float gradient) const {
    const float a = multipliers_[example];
    return double{std::max(a * gradient, (a - examples_[example].bound) * gradient)};
  }

  /// P(u) - D(a), of all examples.
  double gap() const {
    double gap = 0;
    for (std::size_t i = 0; i < examples_.size(); ++i) gap += gap_term(i, gradient_of(i));
    return gap;
  }

  /// The rows of all examples exceed the cache, and are read in random order: the next one is
  /// fetched while the current one is computed with.
  void fetch_row_of(int example) const {
    const float* next = features_.row(examples_[static_cast<std::size_t>(example)].row);
    for (std::size_t i = 0; i < features_.row_size(); i += kKernelBlock)
      __builtin_prefetch(next + i);
  }

  float gradient_of(std::size_t example) const {
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
    multiplier_sum_ += double{multiplier} - double{before};
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
  double multiplier_sum_ = 0;
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
