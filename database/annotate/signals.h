// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace flinch::database {

/// The frames from `first` to `last`, both included.
struct FrameSpan {
  std::size_t first = 0;
  std::size_t last = 0;

  std::size_t count() const { return last - first + 1; }
  bool contains(std::size_t frame) const { return first <= frame && frame <= last; }
};

/// Returns how many frames last this long, rounded.
std::size_t frames_in(double duration_s, float rate_hz);

/// Returns the mean of each value and its `reach` neighbours on either side. Beyond the ends, the
/// first and the last value go on.
std::vector<float> moving_mean(const std::vector<float>& values, std::size_t reach);

/// Returns the order statistic at or below a quantile of at least one value.
float order_statistic(std::vector<float> values, float fraction);

/// Returns the median of the values up to `reach` before and after each one, fewer at the ends. For
/// speed it is computed at every `step`th value from every `step`th value, and holds until the
/// next.
std::vector<float> running_median(const std::vector<float>& values, std::size_t reach,
                                  std::size_t step);

/// Returns the spans in which `is_in` holds, in order.
std::vector<FrameSpan> spans_of(const std::vector<bool>& is_in);

}  // namespace flinch::database
