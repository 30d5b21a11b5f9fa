// SPDX-License-Identifier: MIT
#include "features/portable_math.h"

#include <array>
#include <cmath>
#include <numbers>

namespace flinch::features {
namespace {

// ln 2 = kLn2High + kLn2Low, where multiples of the first by exponents are exact.
constexpr double kLn2High = 0x1.62e42fefa38p-1;
constexpr double kLn2Low = 0x1.ef35793c7673p-45;

/// Evaluates c[0] + c[1] x + c[2] x^2 + … from the last coefficient to the first (Horner).
template <std::size_t kCount>
double polynomial(double x, const std::array<double, kCount>& c) {
  double sum = c[kCount - 1];
  for (std::size_t i = kCount - 1; i > 0; --i) sum = sum * x + c[i - 1];
  return sum;
}

/// The first coefficients of the Taylor series of e^x from x^first on, every step-th, with
/// alternating signs if the step is 2: cos for first 0, sin for first 1.
template <std::size_t kCount>
constexpr std::array<double, kCount> taylor(int first, int step) {
  std::array<double, kCount> c{};
  double factorial = 1;
  int power = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const int wanted = first + step * static_cast<int>(i);
    while (power < wanted) factorial *= ++power;  // exact up to 18!
    c[i] = (step == 2 && i % 2 == 1 ? -1 : 1) / factorial;
  }
  return c;
}

/// 1, 1/3, 1/5, …
template <std::size_t kCount>
constexpr std::array<double, kCount> odd_reciprocals() {
  std::array<double, kCount> c{};
  for (std::size_t i = 0; i < kCount; ++i) c[i] = 1 / (2 * static_cast<double>(i) + 1);
  return c;
}

}  // namespace

// With n = round(x / ln 2) and r = x - n ln 2, |r| <= ln 2 / 2: e^x = 2^n e^r. The first term that
// the series leaves out, r^14 / 14!, is below 5e-18.
double portable_exp(double x) {
  constexpr auto kSeries = taylor<14>(0, 1);
  if (x < -708) return 0;
  const double n = std::floor(x * std::numbers::log2e + 0.5);
  const double r = (x - n * kLn2High) - n * kLn2Low;
  return std::ldexp(polynomial(r, kSeries), static_cast<int>(n));
}

// With x = 2^e m, m from sqrt(1/2) to sqrt(2), and s = (m - 1) / (m + 1):
//   ln x = e ln 2 + 2 (s + s^3/3 + s^5/5 + …).
// As s^2 <= 0.0295, the first term left out is below 2e-17 of the sum.
double portable_log(double x) {
  constexpr auto kSeries = odd_reciprocals<11>();
  int e = 0;
  double m = std::frexp(x, &e);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --e;
  }
  const double s = (m - 1) / (m + 1);
  return e * kLn2High + (e * kLn2Low + 2 * s * polynomial(s * s, kSeries));
}

// The nearest quarter turn is taken off exactly, which leaves an angle of at most pi / 4. The first
// terms that the series leave out are below 3e-18.
double cos_of_turns(double turns) {
  constexpr auto kCos = taylor<9>(0, 2);
  constexpr auto kSin = taylor<9>(1, 2);
  const double quarters = std::floor(4 * turns + 0.5);
  const double angle = 2 * std::numbers::pi * (turns - quarters / 4);
  const double square = angle * angle;
  switch (static_cast<int>(quarters) % 4) {
    case 0:
      return polynomial(square, kCos);
    case 1:
      return -angle * polynomial(square, kSin);
    case 2:
      return -polynomial(square, kCos);
    default:
      return angle * polynomial(square, kSin);
  }
}

}  // namespace flinch::features
