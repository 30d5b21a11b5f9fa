// SPDX-License-Identifier: MIT
#include "train/store/scenario_range.h"

#include <algorithm>

#include "motion/error.h"

namespace flinch::train {

std::string text_of(const ScenarioRange& range) {
  return "scenarios " + std::to_string(range.first) + " to " + std::to_string(range.end() - 1);
}

bool contains(const ScenarioRange& outer, const ScenarioRange& inner) {
  return inner.count == 0 || (inner.first >= outer.first && inner.end() <= outer.end());
}

void take_out(const ScenarioRange& range, std::vector<ScenarioRange>& ranges) {
  const auto found = std::ranges::find_if(
      ranges, [&range](const ScenarioRange& whole) { return contains(whole, range); });
  if (found == ranges.end())
    throw Error("", text_of(range) + " are not missing; each can be added once");
  const ScenarioRange before{found->first, range.first - found->first};
  const ScenarioRange after{range.end(), found->end() - range.end()};
  auto place = ranges.erase(found);
  if (after.count > 0) place = ranges.insert(place, after);
  if (before.count > 0) ranges.insert(place, before);
}

}  // namespace flinch::train
