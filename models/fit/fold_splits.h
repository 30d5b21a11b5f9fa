// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/training_set.h"

namespace flinch::models {

/// One fold: the observations that it holds out, and a model's training set of all the others.
struct FoldSplit {
  std::vector<int> held_out;
  TrainingSet training;
};

/// One a fold; `fold` has each observation's, below 0 where it is among the others of all.
std::vector<FoldSplit> make_fold_splits(const TrainingSet& set, std::span<const int> fold);

}  // namespace flinch::models
