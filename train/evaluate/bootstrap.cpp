// SPDX-License-Identifier: MIT
#include "train/evaluate/bootstrap.h"

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

Resamples draw_resamples(std::size_t count, std::size_t resamples, std::uint64_t seed) {
  Resamples drawn(resamples, std::vector<std::uint32_t>(count));
  for (std::size_t i = 0; i < resamples; ++i) {
    features::Random random(seed, features::RandomStream::bootstrap, i);
    for (std::uint32_t& index : drawn[i]) index = static_cast<std::uint32_t>(random.index(count));
  }
  return drawn;
}

ResampledMean resampled_mean(std::span<const double> values, const Resamples& resamples) {
  ResampledMean result;
  for (const double value : values) result.mean += value;
  result.mean /= static_cast<double>(values.size());
  result.resampled.reserve(resamples.size());
  for (const auto& indices : resamples) {
    double sum = 0;
    for (const std::uint32_t index : indices) sum += values[index];
    result.resampled.push_back(sum / static_cast<double>(indices.size()));
  }
  return result;
}

Interval percentile_interval(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  std::ranges::sort(values);
  return {percentile(values, 0.025), percentile(values, 0.975)};
}

}  // namespace flinch::train
