// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "models/fit/training_set.h"
#include "models/knn.h"

namespace flinch::models {

/// Parameters of a KNN.
struct KnnParameters {
  int k = 1;
  KnnVote vote = KnnVote::majority;

  bool operator==(const KnnParameters&) const = default;
};

/// Returns the parameters for cross-validation: k of 1, 3, 5, 7, 10, 15 and 25, each with both
/// votes.
std::vector<KnnParameters> knn_grid();

/// Returns parameters with the same k that average costs.
std::vector<KnnParameters> knn_cost_grid();

/// Stores the observations and, for a KNN that averages costs, the cost of every clip, quantised to
/// 65534 steps from zero to the maximum. Throws Error for a set that check() rejects, for k below 1
/// or above kMaxNeighbours, and where costs are averaged but the set has none.
KnnModel fit_knn(const TrainingSet& set, const KnnParameters& parameters);

/// Exact neighbour search by FLANN's single kd-tree: returns the same as nearest() over all
/// observations, to the bit and in the same order.
class NeighbourIndex {
 public:
  /// `points` is row-major with one row of feature_count per observation; it may be empty.
  NeighbourIndex(std::span<const double> points, int feature_count);
  ~NeighbourIndex();
  NeighbourIndex(NeighbourIndex&&) noexcept;
  NeighbourIndex& operator=(NeighbourIndex&&) noexcept;

  /// Returns the k observations nearest to `scaled`, ties by the lower index; fewer when there are
  /// fewer than k.
  std::vector<Neighbour> nearest(std::span<const double> scaled, int k) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace flinch::models
