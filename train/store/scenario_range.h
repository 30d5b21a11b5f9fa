// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flinch::train {

/// Scenarios of consecutive numbers: first, first + 1, …
struct ScenarioRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  std::uint64_t end() const { return first + count; }
  bool operator==(const ScenarioRange&) const = default;
};

/// Scenario numbers end where the signed integers of a store's rows do.
inline constexpr std::uint64_t kScenarioNumberEnd = std::uint64_t{1} << 63;

/// "scenarios 3 to 7" of a range that is not empty.
std::string text_of(const ScenarioRange& range);

/// Whether all of `inner` is in `outer`; nothing is in everything.
bool contains(const ScenarioRange& outer, const ScenarioRange& inner);

/// Takes `range`, which one of `ranges` contains, out of these ranges by rising number.
void take_out(const ScenarioRange& range, std::vector<ScenarioRange>& ranges);

}  // namespace flinch::train
