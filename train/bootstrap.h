// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace flinch::train {

/// A 95 % interval; not a number where the statistic is not defined.
struct Interval {
  double low = 0;
  double high = 0;
};

/// `resamples` samples of `count` indices below `count`, drawn with replacement from `seed`: used
/// for every statistic, so that differences are paired.
std::vector<std::vector<std::uint32_t>> draw_resamples(std::size_t count, std::size_t resamples,
                                                       std::uint64_t seed);

/// The percentile bootstrap (Efron and Tibshirani 1993, chapter 13): the 2.5th and 97.5th
/// percentiles of the statistic over the resamples, linear between order statistics.
Interval percentile_interval(
    const std::vector<std::vector<std::uint32_t>>& resamples,
    const std::function<double(std::span<const std::uint32_t>)>& statistic);

}  // namespace flinch::train
