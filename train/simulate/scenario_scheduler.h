// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "train/store/scenario_range.h"

namespace flinch::train {

/// Hands out the scenarios that a run still has to simulate, in ranges: small ones first, so that
/// something is committed and known of the rate soon, then ones of a second or two of work, and
/// small ones again as the end nears, so that nobody waits long for the last.
class ScenarioScheduler {
 public:
  /// `missing` in the order to simulate in. `workers` processes will ask, and each range should be
  /// of `max_per_thread` scenarios for each of their threads.
  ScenarioScheduler(const std::vector<ScenarioRange>& missing, int workers,
                    std::uint64_t max_per_thread);

  /// The next range for a process of this many threads; nothing when all are handed out.
  std::optional<ScenarioRange> next(int threads);
  /// Takes back a range that was handed out: it is the next.
  void put_back(ScenarioRange range);

 private:
  std::deque<ScenarioRange> missing_;
  std::uint64_t workers_;
  std::uint64_t max_per_thread_;
  std::uint64_t remaining_ = 0;
  std::uint64_t handed_out_ = 0;
};

}  // namespace flinch::train
