// SPDX-License-Identifier: MIT
#include "models/fit/fold_splits.h"

#include <algorithm>
#include <cstddef>

namespace flinch::models {

std::vector<FoldSplit> make_fold_splits(const TrainingSet& set, std::span<const int> fold) {
  const int count = fold.empty() ? 0 : *std::max_element(fold.begin(), fold.end()) + 1;
  std::vector<FoldSplit> splits(static_cast<std::size_t>(count));
  for (int f = 0; f < count; ++f) {
    std::vector<int> others;
    FoldSplit& split = splits[static_cast<std::size_t>(f)];
    for (int i = 0; i < set.size(); ++i) {
      (fold[static_cast<std::size_t>(i)] == f ? split.held_out : others).push_back(i);
    }
    split.training = subset(set, others);
  }
  return splits;
}

}  // namespace flinch::models
