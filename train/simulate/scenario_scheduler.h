// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "train/store/scenario_range.h"

namespace flinch::train {

/// Sizes of the ranges that are handed out.
struct RangeSizes {
  std::uint64_t max_per_thread = 0;  ///< scenarios
  std::uint64_t growth = 1;          ///< a range is at most this many times all that was handed out
};

/// Hands out the scenarios that a run still has to simulate, in ranges: small ones first, so that
/// something is soon committed and the rate is soon known, then ranges of a second or two of work,
/// and small ones again towards the end, so that no process waits long for the last.
class ScenarioScheduler {
 public:
  /// `missing` is in the order in which to simulate. `workers` processes will ask for ranges.
  ScenarioScheduler(const std::vector<ScenarioRange>& missing, int workers, RangeSizes sizes);

  /// Returns the next range for a process with this many threads, or nothing when all are handed
  /// out.
  std::optional<ScenarioRange> next(int threads);
  /// Takes back a range that was handed out and hands it out next.
  void put_back(ScenarioRange range);

 private:
  std::deque<ScenarioRange> missing_;
  std::uint64_t workers_;
  RangeSizes sizes_;
  std::uint64_t remaining_ = 0;
  std::uint64_t handed_out_ = 0;
};

}  // namespace flinch::train
