// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/cross_validation.h"

namespace flinch::models {

/// Returns the choices of models with these parameters for each observation in cross-validation:
/// those that it asks the score of, -1 for the others.
template <typename Parameters>
std::vector<int> held_out_choices(const TrainingSet& set, const Parameters& parameters,
                                  std::span<const int> fold) {
  std::vector<int> choices(set.label.size(), -1);
  const LossFunction record = [&choices](int observation, int chosen) {
    choices[static_cast<std::size_t>(observation)] = chosen;
    return 0.0;
  };
  choose_parameters(set, std::span(&parameters, 1), fold, record);
  return choices;
}

/// Returns the observations that are not in fold `held_out`.
inline TrainingSet all_except(const TrainingSet& set, std::span<const int> fold, int held_out) {
  std::vector<int> others;
  for (int i = 0; i < set.size(); ++i) {
    if (fold[static_cast<std::size_t>(i)] != held_out) others.push_back(i);
  }
  return subset(set, others);
}

}  // namespace flinch::models
