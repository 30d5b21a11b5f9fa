// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "models/fit/training_set.h"

namespace flinch::models {

/// Returns uniform values in [-1, 1], rounded to floats like scaled features.
inline std::vector<double> random_point(std::mt19937_64& random, int feature_count) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<double> point(static_cast<std::size_t>(feature_count));
  for (double& value : point) {
    value = double{uniform(random)};
  }
  return point;
}

/// Returns a set in which every clip is allowed for every observation.
inline TrainingSet make_set(int feature_count, std::vector<double> points, std::vector<int> label,
                            int clip_count) {
  TrainingSet set;
  set.feature_count = feature_count;
  set.points = std::move(points);
  set.mask.assign(label.size(), 0);
  set.label = std::move(label);
  set.masks = {ClipMask(static_cast<std::size_t>(clip_count), true)};
  return set;
}

/// Returns the set's observations sorted by label, those of one label in their order: libsvm, which
/// numbers classes by first appearance, then has them in ascending order.
inline TrainingSet sorted_by_label(const TrainingSet& set) {
  std::vector<int> order(set.label.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&set](int i) { return set.label[static_cast<std::size_t>(i)]; });
  return subset(set, order);
}

/// Returns overlapping clouds around random centres, one per class. Class c has label 2 c + 1, so
/// labels differ from class indices.
inline TrainingSet random_clouds(std::uint64_t seed, int count, int class_count,
                                 int feature_count) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> centres;
  for (int c = 0; c < class_count; ++c) {
    centres.push_back(random_point(random, feature_count));
  }
  std::vector<double> points;
  std::vector<int> label;
  for (int i = 0; i < count; ++i) {
    const auto c = static_cast<std::size_t>(random() % static_cast<std::uint64_t>(class_count));
    const std::vector<double> offset = random_point(random, feature_count);
    for (std::size_t f = 0; f < offset.size(); ++f) {
      points.push_back(
          static_cast<double>(static_cast<float>(0.5 * centres[c][f] + 0.5 * offset[f])));
    }
    label.push_back(2 * static_cast<int>(c) + 1);
  }
  return make_set(feature_count, std::move(points), std::move(label), 2 * class_count);
}

/// Returns the set with costs: that of clip c at x is (3 + c's own linear function of x)^2 / 10, so
/// that costs are smooth and every clip is the best somewhere. Each observation's label is its
/// cheapest allowed clip; clips that its mask forbids were not tried.
inline TrainingSet with_costs(TrainingSet set, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> planes;
  for (std::size_t clip = 0; clip < set.clip_count(); ++clip) {
    planes.push_back(random_point(random, set.feature_count));
  }
  set.cost.clear();
  for (int i = 0; i < set.size(); ++i) {
    const ClipMask& allowed = set.allowed_clips(i);
    int best = -1;
    float best_cost = 0;
    for (std::size_t clip = 0; clip < set.clip_count(); ++clip) {
      double height = 3;
      for (std::size_t f = 0; f < planes[clip].size(); ++f) {
        height += planes[clip][f] * set.point(i)[f];
      }
      set.cost.push_back(allowed[clip] ? static_cast<float>(height * height / 10)
                                       : std::numeric_limits<float>::infinity());
      if (allowed[clip] && (best < 0 || set.cost.back() < best_cost)) {
        best = static_cast<int>(clip);
        best_cost = set.cost.back();
      }
    }
    set.label[static_cast<std::size_t>(i)] = best;
  }
  return set;
}

/// Returns a set of 120 clips with costs and four masks, used in turn: mask m allows the 42
/// consecutive clips from number 30 m on.
inline TrainingSet four_masks(std::uint64_t seed, int count, int feature_count) {
  TrainingSet set = random_clouds(seed, count, 60, feature_count);
  set.masks.assign(4, ClipMask(120));
  for (std::size_t mask = 0; mask < 4; ++mask) {
    for (std::size_t clip = 0; clip < 42; ++clip) {
      set.masks[mask][(30 * mask + clip) % 120] = true;
    }
  }
  for (int i = 0; i < count; ++i) {
    set.mask[static_cast<std::size_t>(i)] = i % 4;
  }
  return with_costs(std::move(set), seed + 1);
}

}  // namespace flinch::models
