// SPDX-License-Identifier: MIT
#include "database/annotate/signals.h"

#include <algorithm>
#include <cmath>

namespace flinch::database {

std::size_t frames_in(double duration_s, float rate_hz) {
  return static_cast<std::size_t>(std::lround(duration_s * static_cast<double>(rate_hz)));
}

std::vector<float> moving_mean(const std::vector<float>& values, std::size_t reach) {
  std::vector<float> means;
  means.reserve(values.size());
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  const auto width = static_cast<std::ptrdiff_t>(reach);
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    double sum = 0;
    for (std::ptrdiff_t k = i - width; k <= i + width; ++k) {
      sum += static_cast<double>(
          values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, last))]);
    }
    means.push_back(static_cast<float>(sum / static_cast<double>(2 * reach + 1)));
  }
  return means;
}

float order_statistic(std::vector<float> values, float fraction) {
  const auto index = static_cast<std::ptrdiff_t>(fraction * static_cast<float>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

std::vector<float> running_median(const std::vector<float>& values, std::size_t reach,
                                  std::size_t step) {
  std::vector<float> medians(values.size());
  std::vector<float> window;
  for (std::size_t i = 0; i < values.size(); i += step) {
    const std::size_t before = std::min(reach / step * step, i);
    window.clear();
    for (std::size_t k = i - before; k <= i + reach && k < values.size(); k += step) {
      window.push_back(values[k]);
    }
    const float median = order_statistic(window, 0.5F);
    for (std::size_t k = i; k < std::min(i + step, values.size()); ++k) medians[k] = median;
  }
  return medians;
}

std::vector<FrameSpan> spans_of(const std::vector<bool>& is_in) {
  std::vector<FrameSpan> spans;
  for (std::size_t i = 0; i < is_in.size(); ++i) {
    if (!is_in[i]) continue;
    if (i > 0 && is_in[i - 1]) {
      spans.back().last = i;
    } else {
      spans.push_back({i, i});
    }
  }
  return spans;
}

}  // namespace flinch::database
