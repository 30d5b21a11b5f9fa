// SPDX-License-Identifier: MIT
#include "models/svm_kernel.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "models/integer_power.h"

namespace flinch::models {
namespace {

constexpr std::size_t kLanes = SvmModel::kLanes;
using Lanes = Eigen::Array<float, kLanes, 1>;

double norm(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

// Upper bound on the difference between a kernel value computed in float and in double, over all
// vectors; n features, u = 2^-24 is the unit roundoff.
//
// Polynomial, with B = gamma |x| max|v| + |coef0|: the dot product of n terms, with x rounded to
// float, has an error of at most (n + 1) u |x| |v| in any order of addition; rounding and applying
// gamma and coef0 add 4 u B. With an error of (n + 5) u B in the base and one rounding per
// multiplication, the error is at most ((1 + (n + 6) u)^degree - 1) B^degree.
//
// RBF, with t = gamma |x - v|^2: the sum of squares has a relative error of (n + 4) u, plus 2 u for
// gamma's rounding and product, plus an absolute one of 2 u |x| |x - v| for the rounding of x. The
// exponential turns the first into (n + 6) u t e^-t <= (n + 6) u / e, and the last into 2 u
// sqrt(gamma) |x| sqrt(t) e^-t <= 0.86 u sqrt(gamma) |x|; its own error is a few u.
//
// A tenth is added for terms of second order in u and for underflow; summing such values in double
// adds less than that tenth. Infinite where float might overflow.
double kernel_error(const SvmModel& model, std::span<const double> scaled) {
  constexpr double kUnit = 0x1p-24;
  constexpr double kUnderflow = 16 * double{std::numeric_limits<float>::min()};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kSafe = 1e15;  // its square fits into a float
  const auto n = static_cast<double>(scaled.size());
  if (!(norm(scaled) < kSafe && model.largest_norm < kSafe)) return kInfinity;
  if (model.kernel == SvmKernel::polynomial) {
    const double max_base = model.gamma * norm(scaled) * model.largest_norm + std::abs(model.coef0);
    const double largest = std::pow(max_base, model.degree);
    if (!(largest < kSafe)) return kInfinity;
    return 1.1 * std::expm1((model.degree + 1.0) * (n + 6) * kUnit) * largest + kUnderflow;
  }
  const double t = (n + 6) / std::exp(1.0) + 0.86 * std::sqrt(model.gamma) * norm(scaled) + 8;
  return 1.1 * kUnit * t + kUnderflow;
}

/// Number of vectors that are evaluated at once.
constexpr std::size_t kRows = 8;
using RowValues = Eigen::Array<float, kRows, 1>;

/// Sums of term(x, v) over the point's values x and the values v of each row.
template <typename Term>
RowValues sums_of(std::span<const float> point, const std::array<const float*, kRows>& rows,
                  const Term& term) {
  std::array<Lanes, kRows> sums;
  sums.fill(Lanes::Zero());
  for (std::size_t f = 0; f < point.size(); f += kLanes) {
    const Lanes x = Eigen::Map<const Lanes>(&point[f]);
    for (std::size_t row = 0; row < kRows; ++row) {
      sums[row] += term(x, Eigen::Map<const Lanes>(rows[row] + f));
    }
  }
  RowValues values;
  for (std::size_t row = 0; row < kRows; ++row) {
    values[static_cast<Eigen::Index>(row)] = sums[row].sum();
  }
  return values;
}

RowValues kernels_of(const SvmModel& model, std::span<const float> point,
                     const std::array<const float*, kRows>& rows) {
  const auto gamma = static_cast<float>(model.gamma);
  if (model.kernel == SvmKernel::polynomial) {
    const RowValues dots =
        sums_of(point, rows, [](const Lanes& x, const Lanes& v) -> Lanes { return x * v; });
    return integer_power<RowValues>(gamma * dots + static_cast<float>(model.coef0), model.degree,
                                    RowValues::Ones());
  }
  const RowValues squares = sums_of(
      point, rows, [](const Lanes& x, const Lanes& v) -> Lanes { return (x - v).square(); });
  return (-gamma * squares).exp();
}

}  // namespace

KernelValues::KernelValues(const SvmModel& model, std::span<const double> scaled,
                           std::span<const std::size_t> classes, MemoryResource memory)
    : model_(model),
      error_(kernel_error(model, scaled)),
      x_(model.row_size(), 0.0F, memory),
      first_of_class_(model.label.size(), memory),
      value_(memory) {
  std::ranges::transform(scaled, x_.begin(), [](double x) { return static_cast<float>(x); });
  std::size_t count = 0;
  for (const std::size_t c : classes) {
    first_of_class_[c] = count;
    count += static_cast<std::size_t>(model.vectors_of_class[c]);
  }
  value_.resize(count);
  for (const std::size_t c : classes) {
    const auto first = static_cast<std::size_t>(model.first_of_class[c]);
    evaluate(first, first + static_cast<std::size_t>(model.vectors_of_class[c]),
             value_.data() + first_of_class_[c]);
  }
}

/// Evaluates the vectors from begin to end; the last vector is repeated to fill the rows.
void KernelValues::evaluate(std::size_t begin, std::size_t end, float* values) const {
  for (; begin < end; begin += kRows, values += kRows) {
    std::array<const float*, kRows> rows{};
    for (std::size_t row = 0; row < kRows; ++row) {
      rows[row] = model_.support_vectors.data() + std::min(begin + row, end - 1) * x_.size();
    }
    const RowValues kernels = kernels_of(model_, x_, rows);
    std::copy_n(kernels.data(), std::min(kRows, end - begin), values);
  }
}

}  // namespace flinch::models
