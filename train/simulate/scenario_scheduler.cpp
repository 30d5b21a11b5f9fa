// SPDX-License-Identifier: MIT
#include "train/simulate/scenario_scheduler.h"

#include <algorithm>

namespace flinch::train {

namespace {

constexpr std::uint64_t kMinPerThread = 16;  // scenarios per thread

}  // namespace

ScenarioScheduler::ScenarioScheduler(const std::vector<ScenarioRange>& missing, int workers,
                                     RangeSizes sizes)
    : missing_(missing.begin(), missing.end()),
      workers_(static_cast<std::uint64_t>(workers)),
      sizes_(sizes) {
  sizes_.max_per_thread = std::max(sizes_.max_per_thread, kMinPerThread);
  for (const ScenarioRange& range : missing) remaining_ += range.count;
}

// Hands out `growth` times as many scenarios as each process has received so far, which for 1
// doubles the size from range to range, but at most half of each process' share of the rest unless
// one process does everything.
std::optional<ScenarioRange> ScenarioScheduler::next(int threads) {
  if (missing_.empty()) return std::nullopt;
  const auto each = static_cast<std::uint64_t>(threads);
  std::uint64_t size = sizes_.growth * handed_out_ / workers_;
  if (workers_ > 1) size = std::min(size, remaining_ / (2 * workers_));
  size = std::clamp(size, kMinPerThread * each, sizes_.max_per_thread * each);

  ScenarioRange& front = missing_.front();
  const ScenarioRange range{front.first, std::min(size, front.count)};
  front = {range.end(), front.count - range.count};
  if (front.count == 0) missing_.pop_front();
  remaining_ -= range.count;
  handed_out_ += range.count;
  return range;
}

void ScenarioScheduler::put_back(ScenarioRange range) {
  missing_.push_front(range);
  remaining_ += range.count;
}

}  // namespace flinch::train
