// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace flinch::train {

/// A 95 % confidence interval; not a number where the statistic is undefined.
struct Interval {
  double low = 0;
  double high = 0;
};

/// A statistic of a sample and its confidence interval.
struct Estimate {
  double value = 0;
  Interval interval;
};

/// Number of resamples behind every interval of the evaluation.
inline constexpr std::size_t kResampleCount = 2000;

/// Resamples of a sample: indices drawn with replacement.
using Resamples = std::vector<std::vector<std::uint32_t>>;

/// Draws `resamples` times `count` indices below `count`, with replacement, from `seed`. All
/// statistics use the same draws, so that differences are paired.
Resamples draw_resamples(std::size_t count, std::size_t resamples, std::uint64_t seed);

/// The mean of all values and of each resample. Statistics are computed from these, value by value.
struct ResampledMean {
  double mean = 0;
  std::vector<double> resampled;
};
ResampledMean resampled_mean(std::span<const double> values, const Resamples& resamples);

/// Returns the percentile bootstrap interval (Efron and Tibshirani 1993, chapter 13): the 2.5th and
/// 97.5th percentiles of a statistic over the resamples, with linear interpolation between order
/// statistics. Ignores values that are not numbers.
Interval percentile_interval(std::vector<double> values);

/// Returns a statistic of some means, and its interval over the resamples.
template <class Statistic, class... Means>
Estimate estimate(const Statistic& statistic, const ResampledMean& first, const Means&... others) {
  std::vector<double> values(first.resampled.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = statistic(first.resampled[i], others.resampled[i]...);
  return {statistic(first.mean, others.mean...), percentile_interval(std::move(values))};
}

}  // namespace flinch::train
