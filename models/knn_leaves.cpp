// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

#include "models/knn.h"

namespace flinch::models {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The points as rows, with their comparison.
struct Rows {
  std::span<const float> values;
  std::size_t feature_count;

  float value(int observation, std::size_t feature) const {
    return values[static_cast<std::size_t>(observation) * feature_count + feature];
  }
};

/// Returns the feature with the largest spread over these observations, the first of equals.
std::size_t widest_feature(const Rows& rows, std::span<const int> observations) {
  std::size_t widest = 0;
  float max_spread = -1;
  for (std::size_t feature = 0; feature < rows.feature_count; ++feature) {
    float min = kInfinity;
    float max = -kInfinity;
    for (const int observation : observations) {
      min = std::min(min, rows.value(observation, feature));
      max = std::max(max, rows.value(observation, feature));
    }
    if (max - min > max_spread) {
      max_spread = max - min;
      widest = feature;
    }
  }
  return widest;
}

/// Orders the points so that near ones are adjacent: splits them at a multiple of the leaf size
/// along the feature with the largest spread, then each half likewise (Friedman, Bentley and Finkel
/// 1977).
void arrange(const Rows& rows, std::span<int> observations) {
  if (observations.size() <= KnnLeaves::kLeafSize) {
    return;
  }
  const std::size_t feature = widest_feature(rows, observations);
  const std::size_t leaves =
      (observations.size() + KnnLeaves::kLeafSize - 1) / KnnLeaves::kLeafSize;
  const std::size_t half = leaves / 2 * KnnLeaves::kLeafSize;
  const auto is_before = [&](int a, int b) {
    const float value_a = rows.value(a, feature);
    const float value_b = rows.value(b, feature);
    return value_a != value_b ? value_a < value_b : a < b;
  };
  std::nth_element(observations.begin(), observations.begin() + static_cast<std::ptrdiff_t>(half),
                   observations.end(), is_before);
  arrange(rows, observations.first(half));
  arrange(rows, observations.subspan(half));
}

}  // namespace

void build_leaves(KnnModel& model) {
  const Rows rows{model.points, static_cast<std::size_t>(model.feature_count)};
  const std::size_t count = model.label.size();
  const std::size_t leaf_count = (count + KnnLeaves::kLeafSize - 1) / KnnLeaves::kLeafSize;
  const std::size_t groups = (leaf_count + KnnLeaves::kLeafSize - 1) / KnnLeaves::kLeafSize;
  KnnLeaves& leaves = model.leaves;
  leaves.observation.assign(leaf_count * KnnLeaves::kLeafSize, -1);
  std::iota(leaves.observation.begin(),
            leaves.observation.begin() + static_cast<std::ptrdiff_t>(count), 0);
  arrange(rows, std::span(leaves.observation).first(count));
  leaves.points.assign(leaf_count * KnnLeaves::kLeafSize * rows.feature_count, kInfinity);
  leaves.lower.assign(groups * KnnLeaves::kLeafSize * rows.feature_count, kInfinity);
  leaves.upper.assign(leaves.lower.size(), kInfinity);
  for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
    for (std::size_t feature = 0; feature < rows.feature_count; ++feature) {
      const std::size_t box =
          (leaf / KnnLeaves::kLeafSize * rows.feature_count + feature) * KnnLeaves::kLeafSize +
          leaf % KnnLeaves::kLeafSize;
      leaves.upper[box] = -kInfinity;
      for (std::size_t i = 0; i < KnnLeaves::kLeafSize; ++i) {
        const int observation = leaves.observation[leaf * KnnLeaves::kLeafSize + i];
        if (observation < 0) {
          continue;
        }
        const float value = rows.value(observation, feature);
        leaves.points[(leaf * rows.feature_count + feature) * KnnLeaves::kLeafSize + i] = value;
        leaves.lower[box] = std::min(leaves.lower[box], value);
        leaves.upper[box] = std::max(leaves.upper[box], value);
      }
    }
  }
}

}  // namespace flinch::models
