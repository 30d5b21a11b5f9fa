// SPDX-License-Identifier: MIT
#include "features/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace flinch::features {
namespace {

constexpr int kSamples = 100'000;

/// How far `found` is from `exact`, in units in the last place of a double of that size.
double ulps(double found, long double exact) {
  const double size = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(std::abs(static_cast<long double>(found) - exact)) / unit;
}

// The C library's functions of long double have 11 bits more than a double.

TEST(PortableMath, ExpIsWithinItsStatedError) {
  std::mt19937_64 random(1);
  for (const double bound : {0.1, 2.0, 700.0}) {
    std::uniform_real_distribution<double> uniform(-bound, bound);
    for (int i = 0; i < kSamples; ++i) {
      const double x = uniform(random);
      ASSERT_LE(ulps(portable_exp(x), std::exp(static_cast<long double>(x))), 1.2) << x;
    }
  }
  EXPECT_EQ(portable_exp(0), 1);
  EXPECT_EQ(portable_exp(-709), 0);
  EXPECT_EQ(portable_exp(-std::numeric_limits<double>::infinity()), 0);
}

TEST(PortableMath, LogIsWithinItsStatedError) {
  std::mt19937_64 random(2);
  for (const double bound : {1e-3, 2.0, 700.0}) {
    std::uniform_real_distribution<double> uniform(-bound, bound);
    for (int i = 0; i < kSamples; ++i) {
      const double x = std::exp(uniform(random));
      ASSERT_LE(ulps(portable_log(x), std::log(static_cast<long double>(x))), 3) << x;
    }
  }
  EXPECT_EQ(portable_log(1), 0);
  EXPECT_NEAR(portable_log(0x1p-53), -53 * std::numbers::ln2, 1e-14);
}

TEST(PortableMath, CosIsWithinItsStatedError) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < kSamples; ++i) {
    const double turns = uniform(random);
    const long double angle = 2 * std::numbers::pi_v<long double> * static_cast<long double>(turns);
    ASSERT_NEAR(cos_of_turns(turns), static_cast<double>(std::cos(angle)), 3e-16) << turns;
  }
  EXPECT_EQ(cos_of_turns(0), 1);
  EXPECT_EQ(cos_of_turns(0.25), 0);
  EXPECT_EQ(cos_of_turns(0.5), -1);
  EXPECT_EQ(cos_of_turns(1), 1);
}

}  // namespace
}  // namespace flinch::features
