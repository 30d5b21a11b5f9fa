// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/training_set.h"

namespace flinch::models {

/// One fold: the observations that it holds out, and the training set of all others.
struct FoldSplit {
  std::vector<int> held_out;
  TrainingSet training;
};

/// Returns one split per fold. `fold` holds each observation's fold; observations with a negative
/// fold are in every training set.
std::vector<FoldSplit> make_fold_splits(const TrainingSet& set, std::span<const int> fold);

}  // namespace flinch::models
