// SPDX-License-Identifier: MIT
#include "train/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flinch::train {
namespace {

TEST(Bootstrap, PercentilesAreLinearBetweenOrderStatistics) {
  // 41 resamples whose statistic is 0, 1, …, 40: the 2.5th percentile is 1, the 97.5th is 39.
  std::vector<std::vector<std::uint32_t>> resamples;
  for (std::uint32_t i = 0; i < 41; ++i) resamples.push_back({40 - i});
  const Interval interval =
      percentile_interval(resamples, [](auto indices) { return static_cast<double>(indices[0]); });
  EXPECT_DOUBLE_EQ(interval.low, 1);
  EXPECT_DOUBLE_EQ(interval.high, 39);
}

TEST(Bootstrap, IntervalOfAMeanIsAboutTwoStandardErrorsWide) {
  // 400 values, half of them 0 and half 1: the mean's standard error is 0.5 / 20 = 0.025.
  const auto resamples = draw_resamples(400, 2000, 1);
  const Interval interval = percentile_interval(resamples, [](auto indices) {
    double sum = 0;
    for (const std::uint32_t index : indices) sum += index % 2;
    return sum / static_cast<double>(indices.size());
  });
  EXPECT_NEAR(interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(interval.high, 0.5 + 1.96 * 0.025, 0.004);
}

TEST(Bootstrap, ResamplesAreTheSameForTheSameSeed) {
  EXPECT_EQ(draw_resamples(50, 10, 3), draw_resamples(50, 10, 3));
  EXPECT_NE(draw_resamples(50, 10, 3), draw_resamples(50, 10, 4));
}

TEST(Bootstrap, AStatisticThatIsNeverDefinedHasNoInterval) {
  const auto resamples = draw_resamples(5, 10, 1);
  const Interval interval =
      percentile_interval(resamples, [](auto) { return std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_TRUE(std::isnan(interval.low));
  EXPECT_TRUE(std::isnan(interval.high));
}

}  // namespace
}  // namespace flinch::train
