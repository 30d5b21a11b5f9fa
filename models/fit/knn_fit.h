// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "models/fit/training_set.h"
#include "models/knn.h"

namespace flinch::models {

/// What a KNN is made with.
struct KnnParameters {
  int k = 1;
  KnnVote vote = KnnVote::majority;

  bool operator==(const KnnParameters&) const = default;
};

/// The parameters to choose from by cross-validation: k of 1, 3, 5, 7, 10, 15 and 25, each with
/// either vote.
std::vector<KnnParameters> knn_grid();

/// The same k, averaging costs.
std::vector<KnnParameters> knn_cost_grid();

/// Keeps the observations, and for a KNN that averages costs what every clip cost, in 65534 steps
/// from nothing to the largest. Throws Error for what check() refuses, for k below 1 or above
/// 65535, and where costs are averaged for a set without them.
KnnModel fit_knn(const TrainingSet& set, const KnnParameters& parameters);

/// Finds exact neighbours by FLANN's single kd-tree: the same as nearest() over all observations,
/// to the bit and in the same order.
class NeighbourIndex {
 public:
  /// `points` is row-major with one row of feature_count an observation; there may be none.
  NeighbourIndex(std::span<const double> points, int feature_count);
  ~NeighbourIndex();
  NeighbourIndex(NeighbourIndex&&) noexcept;
  NeighbourIndex& operator=(NeighbourIndex&&) noexcept;

  /// The k nearest observations to `scaled`, ties by the lower index; fewer when there are not k.
  std::vector<Neighbour> nearest(std::span<const double> scaled, int k) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace flinch::models
