// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flinch::train {

/// A range of consecutive scenario numbers: first, first + 1, …
struct ScenarioRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  std::uint64_t end() const { return first + count; }
  bool operator==(const ScenarioRange&) const = default;
};

/// Scenario numbers must be below this, because a store's rows have signed integers.
inline constexpr std::uint64_t kScenarioNumberEnd = std::uint64_t{1} << 63;

/// Returns "scenarios 3 to 7" for a range that is not empty.
std::string text_of(const ScenarioRange& range);

/// Whether all of `inner` is in `outer`; an empty range is in every range.
bool contains(const ScenarioRange& outer, const ScenarioRange& inner);

/// Removes `range`, which one of `ranges` contains, from `ranges`, which are in ascending order.
void take_out(const ScenarioRange& range, std::vector<ScenarioRange>& ranges);

}  // namespace flinch::train
