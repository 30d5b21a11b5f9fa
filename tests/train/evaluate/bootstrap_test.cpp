// SPDX-License-Identifier: MIT
#include "train/evaluate/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace flinch::train {
namespace {

TEST(Bootstrap, PercentilesAreLinearBetweenOrderStatistics) {
  // 0, 1, …, 40: the 2.5th percentile is 1, the 97.5th is 39.
  std::vector<double> values;
  for (int i = 0; i < 41; ++i) values.push_back(40 - i);
  const Interval interval = percentile_interval(values);
  EXPECT_DOUBLE_EQ(interval.low, 1);
  EXPECT_DOUBLE_EQ(interval.high, 39);
}

TEST(Bootstrap, IntervalOfAMeanReachesAboutTwoStandardErrorsEachWay) {
  // 400 values, half of them 0 and half 1: the mean's standard error is 0.5 / 20 = 0.025.
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  const ResampledMean mean = resampled_mean(values, draw_resamples(400, 2000, 1));
  const Estimate estimated = estimate([](double value) { return value; }, mean);
  EXPECT_DOUBLE_EQ(estimated.value, 0.5);
  EXPECT_NEAR(estimated.interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(estimated.interval.high, 0.5 + 1.96 * 0.025, 0.004);
}

TEST(Bootstrap, ResampledMeanIsTheMeanOfItsIndices) {
  const std::vector<double> values{1, 10, 100};
  const ResampledMean mean = resampled_mean(values, {{0, 0, 1}, {2, 1, 2}});
  EXPECT_DOUBLE_EQ(mean.mean, 37);
  ASSERT_EQ(mean.resampled.size(), 2U);
  EXPECT_DOUBLE_EQ(mean.resampled[0], 4);
  EXPECT_DOUBLE_EQ(mean.resampled[1], 70);
}

// Two rows that differ by a constant differ by it in every resample: pairing removes the variation
// between scenarios.
TEST(Bootstrap, IntervalOfAConstantPairedDifferenceHasZeroWidth) {
  std::vector<double> low;
  std::vector<double> high;
  for (int i = 0; i < 50; ++i) {
    low.push_back(i * i);
    high.push_back(i * i + 0.5);
  }
  const Resamples resamples = draw_resamples(50, 200, 2);
  const Estimate difference =
      estimate(std::minus{}, resampled_mean(high, resamples), resampled_mean(low, resamples));
  EXPECT_NEAR(difference.value, 0.5, 1e-9);
  EXPECT_NEAR(difference.interval.low, 0.5, 1e-9);
  EXPECT_NEAR(difference.interval.high, 0.5, 1e-9);
}

TEST(Bootstrap, ResamplesAreTheSameForTheSameSeed) {
  EXPECT_EQ(draw_resamples(50, 10, 3), draw_resamples(50, 10, 3));
  EXPECT_NE(draw_resamples(50, 10, 3), draw_resamples(50, 10, 4));
}

TEST(Bootstrap, UndefinedStatisticHasNoInterval) {
  const Interval interval =
      percentile_interval(std::vector<double>(10, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(std::isnan(interval.low));
  EXPECT_TRUE(std::isnan(interval.high));
}

}  // namespace
}  // namespace flinch::train
