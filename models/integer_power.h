// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::models {

/// Returns base^exponent by repeated squaring, with the same sequence of multiplications as libsvm.
/// Returns 1 where the exponent is not positive.
template <typename Number>
Number integer_power(Number base, int exponent, Number one) {
  Number result = one;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) {
      result *= base;
    }
    base *= base;
  }
  return result;
}

inline double integer_power(double base, int exponent) {
  return integer_power(base, exponent, 1.0);
}

}  // namespace flinch::models
