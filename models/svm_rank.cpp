// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "models/power.h"
#include "models/svm.h"

namespace flinch::models {
namespace {

using Lanes = Eigen::Array<float, SvmModel::kLanes, 1>;
using DoubleLanes = Eigen::Array<double, SvmModel::kLanes, 1>;
constexpr std::size_t kLanes = SvmModel::kLanes;

double norm(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

// How far a kernel value that is computed in float may lie from the one in double, whichever vector
// it is of; n features, u = 2^-24 the unit roundoff.
//
// Polynomial, with B = gamma |x| max|v| + |coef0|: the dot product of n terms, x rounded to float,
// is off by (n + 1) u |x| |v| at most, gamma and coef0 rounded and applied add 4 u B. A base off by
// (n + 5) u B and one rounding a multiplication make ((1 + (n + 6) u)^degree - 1) B^degree.
//
// RBF, with t = gamma |x - v|^2: the sum of squares is off by (n + 4) u of itself, by gamma's
// rounding and product 2 u more, and by 2 u |x| |x - v| for the rounding of x. The exponential
// turns the first into (n + 6) u t e^-t <= (n + 6) u / e, the second into 2 u sqrt(gamma) |x|
// sqrt(t) e^-t <= 0.86 u sqrt(gamma) |x|; its own error is a few u.
//
// A tenth is added for what is of second order in u, and what underflow may lose; sums of such
// values in double add less than the tenth. Infinite where float might overflow.
double kernel_error(const SvmModel& model, std::span<const double> scaled) {
  constexpr double kUnit = 0x1p-24;
  constexpr double kUnderflow = 16 * double{std::numeric_limits<float>::min()};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kSafe = 1e15;  // its square is a float
  const auto n = static_cast<double>(scaled.size());
  if (!(norm(scaled) < kSafe && model.largest_norm < kSafe)) return kInfinity;
  if (model.kernel == SvmKernel::polynomial) {
    const double most = model.gamma * norm(scaled) * model.largest_norm + std::abs(model.coef0);
    const double largest = std::pow(most, model.degree);
    if (!(largest < kSafe)) return kInfinity;
    return 1.1 * std::expm1((model.degree + 1.0) * (n + 6) * kUnit) * largest + kUnderflow;
  }
  const double t = (n + 6) / std::exp(1.0) + 0.86 * std::sqrt(model.gamma) * norm(scaled) + 8;
  return 1.1 * kUnit * t + kUnderflow;
}

/// The allowed classes play each other; positions are those among the allowed ones.
class Tournament {
 public:
  Tournament(const SvmModel& model, std::span<const double> scaled, std::span<const char> allowed,
             Memory memory)
      : model_(model),
        scaled_(scaled),
        error_(kernel_error(model, scaled)),
        x_(scaled.begin(), scaled.end(), memory),
        classes_(memory),
        begin_(memory),
        kernel_(memory),
        losses_(memory),
        played_(memory) {
    classes_.reserve(allowed.size());
    begin_.reserve(allowed.size());
    std::size_t room = 0;
    for (std::size_t c = 0; c < allowed.size(); ++c) {
      if (!allowed[c]) continue;
      const auto first = static_cast<std::size_t>(model.first_of_class[c]);
      const auto count = static_cast<std::size_t>(model.vectors_of_class[c]);
      classes_.push_back(c);
      begin_.push_back(room + first % kLanes);
      room += ((first % kLanes + count + kLanes - 1) / kLanes) * kLanes;
    }
    kernel_.resize(room);
    losses_.resize(count());
    played_.resize(count() * count());
    for (std::size_t position = 0; position < count(); ++position) evaluate_kernel(position);
  }

  std::size_t count() const { return classes_.size(); }

  void play_all() {
    for (std::size_t a = 0; a < count(); ++a) play_rest_of(a, count());
  }

  /// Knocks out one after the other, so that all but one have lost before any is looked at twice.
  void play_knock_out() {
    std::size_t champion = 0;
    for (std::size_t next = 1; next < count(); ++next) {
      if (!play(champion, next)) champion = next;
    }
  }

  /// Plays until it knows who comes next after those that it gave before.
  RankedClass next() {
    for (;;) {
      const auto [best, runner_up] = leaders();
      if (play_rest_of(best, runner_up)) {
        const int votes = static_cast<int>(count()) - 1 - losses_[best];
        losses_[best] += kTaken;
        return {classes_[best], votes};
      }
    }
  }

 private:
  static constexpr int kTaken = 1 << 20;  // more than there can be losses

  /// Fewest losses so far, then the lower position. Losses only grow, so that nobody else gets
  /// before a class that has played all its games and is still the best.
  bool is_before(std::size_t a, std::size_t b) const {
    return b == count() || losses_[a] < losses_[b] || (losses_[a] == losses_[b] && a < b);
  }

  /// The best two, count() where there is none.
  std::array<std::size_t, 2> leaders() const {
    std::size_t best = count();
    std::size_t second = count();
    for (std::size_t position = 0; position < count(); ++position) {
      if (is_before(position, best)) {
        second = best;
        best = position;
      } else if (is_before(position, second)) {
        second = position;
      }
    }
    return {best, second};
  }

  /// Plays what a class has not played yet, until it comes after where `rival` stands now (who may
  /// fall behind others meanwhile); whether it never does.
  bool play_rest_of(std::size_t one, std::size_t rival) {
    const int limit = rival == count() ? kTaken : losses_[rival];
    for (std::size_t other = 0; other < count(); ++other) {
      if (other == one || played_[one * count() + other]) continue;
      if (one < other) {
        play(one, other);
      } else {
        play(other, one);
      }
      if (losses_[one] > limit || (losses_[one] == limit && rival < one)) return false;
    }
    return true;
  }

  /// Whether a wins against b, a before b.
  bool play(std::size_t a, std::size_t b) {
    const bool wins = is_first_preferred(a, b);
    ++losses_[wins ? b : a];
    played_[a * count() + b] = played_[b * count() + a] = 1;
    return wins;
  }

  void evaluate_kernel(std::size_t position) {
    const std::size_t c = classes_[position];
    const auto first = static_cast<std::size_t>(model_.first_of_class[c]);
    const auto last = first + static_cast<std::size_t>(model_.vectors_of_class[c]);
    double* out = kernel_.data() + begin_[position] - first % kLanes;
    for (std::size_t group = first / kLanes; group * kLanes < last; ++group, out += kLanes) {
      const Lanes values = kernel_of_group(group);
      Eigen::Map<DoubleLanes>{out} = values.cast<double>();
    }
  }

  Lanes kernel_of_group(std::size_t group) const {
    const float* row = model_.support_vectors.data() + group * kLanes * x_.size();
    const auto gamma = static_cast<float>(model_.gamma);
    Lanes sum = Lanes::Zero();
    if (model_.kernel == SvmKernel::polynomial) {
      for (const float x : x_) {
        sum += x * Eigen::Map<const Lanes>(row);
        row += kLanes;
      }
      return power<Lanes>(gamma * sum + static_cast<float>(model_.coef0), model_.degree,
                          Lanes::Ones());
    }
    for (const float x : x_) {
      sum += (x - Eigen::Map<const Lanes>(row)).square();
      row += kLanes;
    }
    return (-gamma * sum).exp();
  }

  /// sum of a K over one side's vectors, the free ones first; moves on to the other side's.
  double side(std::size_t position, std::uint16_t free_count, std::uint16_t bound_count,
              const std::uint16_t*& vector, const double*& coefficient) const {
    const double* kernel = kernel_.data() + begin_[position];
    std::array<double, 2> free{};
    std::array<double, 2> bound{};
    int k = 0;
    for (; k + 1 < free_count; k += 2) {
      free[0] += coefficient[k] * kernel[vector[k]];
      free[1] += coefficient[k + 1] * kernel[vector[k + 1]];
    }
    if (k < free_count) free[0] += coefficient[k] * kernel[vector[k]];
    vector += free_count;
    coefficient += free_count;
    for (k = 0; k + 1 < bound_count; k += 2) {
      bound[0] += kernel[vector[k]];
      bound[1] += kernel[vector[k + 1]];
    }
    if (k < bound_count) bound[0] += kernel[vector[k]];
    vector += bound_count;
    return free[0] + free[1] + model_.bound[classes_[position]] * (bound[0] + bound[1]);
  }

  bool is_first_preferred(std::size_t a, std::size_t b) const {
    const std::size_t i = classes_[a];
    const std::size_t j = classes_[b];
    const SvmMachine& machine = model_.machines[model_.machine_of(i, j)];
    const std::uint16_t* vector = model_.vectors.data() + machine.first_vector;
    const double* coefficient = model_.coefficients.data() + machine.first_coefficient;
    const double first = side(a, machine.count[0], machine.count[1], vector, coefficient);
    const double second = side(b, machine.count[2], machine.count[3], vector, coefficient);
    const double value = first - second - machine.rho;
    // Not a number is beyond no bound either.
    if (std::abs(value) > machine.weight * error_) return value > 0;
    return decision(model_, scaled_, i, j) > 0;
  }

  const SvmModel& model_;
  std::span<const double> scaled_;
  double error_;
  std::pmr::vector<float> x_;
  std::pmr::vector<std::size_t> classes_;  ///< by position
  std::pmr::vector<std::size_t> begin_;    ///< of each position's values in `kernel_`
  std::pmr::vector<double> kernel_;        ///< K(x, v) of the vectors of allowed classes
  std::pmr::vector<int> losses_;           ///< by position
  std::pmr::vector<char> played_;          ///< count() rows of one a position
};

}  // namespace

std::pmr::vector<RankedClass> rank(const SvmModel& model, std::span<const double> scaled,
                                   std::span<const char> allowed, std::size_t most, Memory memory) {
  Tournament tournament(model, scaled, allowed, memory);
  std::pmr::vector<RankedClass> ranked(memory);
  ranked.reserve(tournament.count());
  const std::size_t count = std::min(most, tournament.count());
  if (count == tournament.count()) {
    tournament.play_all();
  } else {
    tournament.play_knock_out();
  }
  while (ranked.size() < count) {
    ranked.push_back(tournament.next());
  }
  return ranked;
}

}  // namespace flinch::models
