// SPDX-License-Identifier: MIT
#include "models/fit/training_set.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "motion/error.h"

namespace flinch::models {
namespace {

void check_observation(const TrainingSet& set, int observation) {
  const std::string which = "observation " + std::to_string(observation);
  for (const double value : set.point(observation)) {
    if (!std::isfinite(value)) {
      throw Error("", which + " has a feature that is not a finite number; simulate it again");
    }
  }
  const auto i = static_cast<std::size_t>(observation);
  if (set.mask[i] < 0 || static_cast<std::size_t>(set.mask[i]) >= set.masks.size()) {
    throw Error("", which + " refers to mask " + std::to_string(set.mask[i]) + " of " +
                        std::to_string(set.masks.size()));
  }
  const ClipMask& allowed = set.allowed_clips(observation);
  const int label = set.label[i];
  if (label < 0 || static_cast<std::size_t>(label) >= allowed.size() ||
      !allowed[static_cast<std::size_t>(label)]) {
    throw Error("", which + " is labelled with clip " + std::to_string(label) +
                        ", which its target does not allow");
  }
}

}  // namespace

void check(const TrainingSet& set) {
  const std::size_t count = set.label.size();
  if (count < 2) {
    throw Error("", "a model needs at least 2 observations and there are " + std::to_string(count) +
                        "; simulate more");
  }
  if (set.feature_count < 1 || set.mask.size() != count ||
      set.points.size() != count * static_cast<std::size_t>(set.feature_count)) {
    throw Error("", "the training set's numbers of points, labels and masks differ");
  }
  if (!set.cost.empty() && set.cost.size() != count * set.clip_count()) {
    throw Error("", "the training set's costs are not one per clip and observation");
  }
  if (!set.unit.empty() && set.unit.size() != count) {
    throw Error("", "the training set's units of cost are not one per observation");
  }
  for (int i = 0; i < set.size(); ++i) {
    check_observation(set, i);
  }
}

void check_costs(const TrainingSet& set) {
  if (set.cost.empty()) {
    throw Error("", "the training set has no costs to learn from");
  }
  for (int i = 0; i < set.size(); ++i) {
    const std::span<const float> costs = set.costs(i);
    if (std::none_of(costs.begin(), costs.end(), [](float cost) { return std::isfinite(cost); })) {
      throw Error("",
                  "observation " + std::to_string(i) + " has no finite cost; simulate it again");
    }
    if (!std::all_of(costs.begin(), costs.end(), [](float cost) { return cost >= 0; })) {
      throw Error("", "observation " + std::to_string(i) +
                          " has a cost that is negative or not a number; simulate it again");
    }
  }
}

std::vector<int> tried_clips(const TrainingSet& set) {
  std::vector<int> clips;
  for (std::size_t clip = 0; clip < set.clip_count(); ++clip) {
    for (int i = 0; i < set.size(); ++i) {
      if (std::isfinite(set.costs(i)[clip])) {
        clips.push_back(static_cast<int>(clip));
        break;
      }
    }
  }
  return clips;
}

TrainingSet subset(const TrainingSet& set, std::span<const int> observations) {
  TrainingSet chosen;
  chosen.feature_count = set.feature_count;
  chosen.masks = set.masks;
  chosen.idle = set.idle;
  for (const int observation : observations) {
    const std::span<const double> point = set.point(observation);
    chosen.points.insert(chosen.points.end(), point.begin(), point.end());
    chosen.label.push_back(set.label[static_cast<std::size_t>(observation)]);
    chosen.mask.push_back(set.mask[static_cast<std::size_t>(observation)]);
    if (!set.unit.empty()) chosen.unit.push_back(set.unit_of(observation));
    if (!set.cost.empty()) {
      const std::span<const float> costs = set.costs(observation);
      chosen.cost.insert(chosen.cost.end(), costs.begin(), costs.end());
    }
  }
  return chosen;
}

}  // namespace flinch::models
