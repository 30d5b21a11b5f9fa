// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "models/training_set.h"

namespace flinch::models {

/// Uniform values in [-1, 1], which are floats as those of scaled features are.
inline std::vector<double> random_point(std::mt19937_64& random, int feature_count) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<double> point(static_cast<std::size_t>(feature_count));
  for (double& value : point) {
    value = double{uniform(random)};
  }
  return point;
}

/// A set whose every observation is allowed every clip.
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

/// Clouds that overlap, one about a random centre a class. Class c has label 2 c + 1, so that
/// labels are not the indices of classes.
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

}  // namespace flinch::models
