// SPDX-License-Identifier: MIT
#include "models/svm_kernel.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "models/power.h"

namespace flinch::models {
namespace {

constexpr std::size_t kLanes = SvmModel::kLanes;
using Lanes = Eigen::Array<float, kLanes, 1>;

double norm(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

// How far a kernel value that is computed in float may lie from the one in double, whichever vector
// it is of; n features, u = 2^-24 the unit roundoff.
//
// Polynomial, with B = gamma |x| max|v| + |coef0|: the dot product of n terms, x rounded to float,
// is off by (n + 1) u |x| |v| at most in whichever order they are added, gamma and coef0 rounded
// and applied add 4 u B. A base off by (n + 5) u B and one rounding a multiplication make
// ((1 + (n + 6) u)^degree - 1) B^degree.
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

/// The sums of term(x, v) over the point's values x and those v of kLanes rows.
template <typename Term>
Lanes sums_of(std::span<const float> point, const std::array<const float*, kLanes>& rows,
              const Term& term) {
  std::array<Lanes, kLanes> sums;
  sums.fill(Lanes::Zero());
  for (std::size_t f = 0; f < point.size(); f += kLanes) {
    const Lanes x = Eigen::Map<const Lanes>(&point[f]);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      sums[lane] += term(x, Eigen::Map<const Lanes>(rows[lane] + f));
    }
  }
  return {sums[0].sum(), sums[1].sum(), sums[2].sum(), sums[3].sum()};
}

}  // namespace

LazyKernel::LazyKernel(const SvmModel& model, std::span<const double> scaled, Memory memory)
    : model_(model),
      error_(kernel_error(model, scaled)),
      x_(model.row_size(), 0.0F, memory),
      value_(static_cast<std::size_t>(model.vector_count()),
             std::numeric_limits<float>::quiet_NaN(), memory),
      missing_(model.vectors_of_class.empty()
                   ? 0
                   : static_cast<std::size_t>(std::ranges::max(model.vectors_of_class)),
               memory) {
  std::ranges::transform(scaled, x_.begin(), [](double x) { return static_cast<float>(x); });
}

// Which are missing is anybody's guess, so that a branch for each would cost more than its value.
const float* LazyKernel::values(std::size_t one, std::span<const std::uint16_t> vectors) {
  const auto first = static_cast<std::size_t>(model_.first_of_class[one]);
  const float* const values = value_.data() + first;
  std::size_t count = 0;
  for (const std::uint16_t vector : vectors) {
    missing_[count] = vector;
    count += std::isnan(values[vector]) ? 1 : 0;
  }
  for (std::size_t begin = 0; begin < count; begin += kLanes) {
    evaluate(first, std::span(missing_).subspan(begin, std::min(kLanes, count - begin)));
  }
  return values;
}

/// At most kLanes of them, and not none; the last fills up.
void LazyKernel::evaluate(std::size_t first, std::span<const std::uint16_t> vectors) {
  std::array<std::size_t, kLanes> places{};
  std::array<const float*, kLanes> rows{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    places[lane] = first + vectors[std::min(lane, vectors.size() - 1)];
    rows[lane] = model_.support_vectors.data() + places[lane] * x_.size();
  }
  const auto gamma = static_cast<float>(model_.gamma);
  Lanes values;
  if (model_.kernel == SvmKernel::polynomial) {
    const Lanes dot = sums_of(x_, rows, [](const Lanes& x, const auto& v) { return x * v; });
    values =
        power<Lanes>(gamma * dot + static_cast<float>(model_.coef0), model_.degree, Lanes::Ones());
  } else {
    const Lanes squares =
        sums_of(x_, rows, [](const Lanes& x, const auto& v) { return (x - v).square(); });
    values = (-gamma * squares).exp();
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    value_[places[lane]] = values[static_cast<Eigen::Index>(lane)];
  }
}

}  // namespace flinch::models
