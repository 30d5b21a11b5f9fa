// SPDX-License-Identifier: MIT
#include "train/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/random.h"

namespace flinch::train {

namespace {

double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

std::vector<std::vector<std::uint32_t>> draw_resamples(std::size_t count, std::size_t resamples,
                                                       std::uint64_t seed) {
  std::vector<std::vector<std::uint32_t>> drawn(resamples, std::vector<std::uint32_t>(count));
  for (std::size_t i = 0; i < resamples; ++i) {
    features::Random random(seed, features::Purpose::bootstrap, i);
    for (std::uint32_t& index : drawn[i]) index = static_cast<std::uint32_t>(random.index(count));
  }
  return drawn;
}

Interval percentile_interval(
    const std::vector<std::vector<std::uint32_t>>& resamples,
    const std::function<double(std::span<const std::uint32_t>)>& statistic) {
  std::vector<double> values;
  values.reserve(resamples.size());
  for (const auto& resample : resamples) values.push_back(statistic(resample));
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  std::ranges::sort(values);
  return {percentile(values, 0.025), percentile(values, 0.975)};
}

}  // namespace flinch::train
