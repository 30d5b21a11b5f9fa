// SPDX-License-Identifier: MIT
#include "models/knn_fit.h"

#include <algorithm>
#include <cstddef>
#include <flann/flann.hpp>
#include <string>
#include <utility>

#include "motion/error.h"

namespace flinch::models {
namespace {

using Distance = flann::L2<double>;

flann::SearchParams exact_search() {
  flann::SearchParams parameters(flann::FLANN_CHECKS_UNLIMITED);
  parameters.cores = 1;
  return parameters;
}

}  // namespace

std::vector<KnnParameters> knn_grid() {
  std::vector<KnnParameters> grid;
  for (const int k : {1, 3, 5, 7, 10, 15, 25}) {
    grid.push_back({k, KnnVote::majority});
    grid.push_back({k, KnnVote::inverse_distance});
  }
  return grid;
}

KnnModel fit_knn(const TrainingSet& set, const KnnParameters& parameters) {
  check(set);
  if (parameters.k < 1) {
    throw Error("", "a KNN needs k of at least 1, not " + std::to_string(parameters.k));
  }
  return {parameters.k, parameters.vote, set.feature_count, set.points, set.label};
}

struct NeighbourIndex::Tree {
  Tree(std::vector<double> rows, std::size_t columns)
      : points(std::move(rows)),
        matrix(points.data(), points.size() / columns, columns),
        index(matrix, flann::KDTreeSingleIndexParams()) {
    index.buildIndex();
  }

  std::vector<double> points;
  flann::Matrix<double> matrix;
  flann::KDTreeSingleIndex<Distance> index;
};

NeighbourIndex::NeighbourIndex(std::vector<double> points, int feature_count)
    : tree_(points.empty() ? nullptr
                           : std::make_unique<Tree>(std::move(points),
                                                    static_cast<std::size_t>(feature_count))) {}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

// FLANN sums a distance four features at a time and keeps any of several points at the k-th
// distance. So it is asked for all points up to a little beyond that distance, which it takes as a
// float; the order among them is then decided by the distance that nearest() computes.
std::vector<Neighbour> NeighbourIndex::nearest(std::span<const double> scaled, int k) const {
  if (tree_ == nullptr || k < 1) {
    return {};
  }
  const std::size_t most = std::min(static_cast<std::size_t>(k), tree_->matrix.rows);
  std::vector<double> query(scaled.begin(), scaled.end());
  const flann::Matrix<double> queries(query.data(), 1, query.size());
  std::vector<std::vector<std::size_t>> indices;
  std::vector<std::vector<double>> distances;
  tree_->index.knnSearch(queries, indices, distances, most, exact_search());
  const auto reach = static_cast<float>(distances[0].back() * (1 + 1e-6) + 1e-12);
  tree_->index.radiusSearch(queries, indices, distances, reach, exact_search());

  std::vector<Neighbour> found;
  for (const std::size_t index : indices[0]) {
    found.push_back({static_cast<int>(index), squared_distance(scaled, tree_->matrix[index])});
  }
  std::sort(found.begin(), found.end(), nearer);
  found.resize(std::min(found.size(), most));
  return found;
}

}  // namespace flinch::models
