// SPDX-License-Identifier: MIT
#include "models/fit/knn_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <flann/flann.hpp>
#include <string>
#include <utility>

#include "motion/error.h"

namespace flinch::models {
namespace {

using Distance = flann::L2<double>;

std::vector<float> to_floats(std::span<const double> scaled) {
  std::vector<float> floats(scaled.size());
  std::transform(scaled.begin(), scaled.end(), floats.begin(), knn_coordinate);
  return floats;
}

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

std::vector<KnnParameters> knn_cost_grid() {
  std::vector<KnnParameters> grid;
  for (const int k : {1, 3, 5, 7, 10, 15, 25}) {
    grid.push_back({k, KnnVote::cost});
  }
  return grid;
}

namespace {

void keep_costs(const TrainingSet& set, KnnModel& model) {
  check_costs(set);
  constexpr double kSteps = KnnModel::kUntried - 1;
  double max_cost = 0;
  for (const float cost : set.cost) {
    max_cost = std::isfinite(cost) ? std::max(max_cost, double{cost}) : max_cost;
  }
  model.clip_count = static_cast<int>(set.clip_count());
  model.cost_step_ns = max_cost > 0 ? static_cast<float>(max_cost / kSteps) : 1.0F;
  for (const float cost : set.cost) {
    const double steps = std::round(double{cost} / double{model.cost_step_ns});
    model.cost.push_back(std::isfinite(cost) ? static_cast<std::uint16_t>(std::min(steps, kSteps))
                                             : KnnModel::kUntried);
  }
}

}  // namespace

KnnModel fit_knn(const TrainingSet& set, const KnnParameters& parameters) {
  check(set);
  if (parameters.k < 1 || parameters.k > kMaxNeighbours) {
    throw Error("", "a KNN needs k from 1 to " + std::to_string(kMaxNeighbours) + ", not " +
                        std::to_string(parameters.k));
  }
  KnnModel model;
  model.k = parameters.k;
  model.vote = parameters.vote;
  model.feature_count = set.feature_count;
  model.points = to_floats(set.points);
  model.label = set.label;
  if (parameters.vote == KnnVote::cost) {
    keep_costs(set, model);
  }
  build_leaves(model);
  return model;
}

// In double precision, but with the model's single-precision coordinates.
struct NeighbourIndex::Tree {
  Tree(std::span<const double> rows, std::size_t columns)
      : floats(to_floats(rows)),
        points(floats.begin(), floats.end()),
        matrix(points.data(), points.size() / columns, columns),
        index(matrix, flann::KDTreeSingleIndexParams()) {
    index.buildIndex();
  }

  std::vector<float> floats;
  std::vector<double> points;
  flann::Matrix<double> matrix;
  flann::KDTreeSingleIndex<Distance> index;
};

NeighbourIndex::NeighbourIndex(std::span<const double> points, int feature_count)
    : tree_(points.empty()
                ? nullptr
                : std::make_unique<Tree>(points, static_cast<std::size_t>(feature_count))) {}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

// FLANN rounds distances differently, and of several points at the k-th distance it keeps an
// arbitrary one. So all points up to slightly beyond that distance are requested, by more than
// single-precision rounding errors; their order is then decided by the distance that nearest()
// computes.
std::vector<Neighbour> NeighbourIndex::nearest(std::span<const double> scaled, int k) const {
  if (tree_ == nullptr || k < 1) {
    return {};
  }
  const std::size_t max_count = std::min(static_cast<std::size_t>(k), tree_->matrix.rows);
  const std::vector<float> coordinates = to_floats(scaled);
  std::vector<double> query(coordinates.begin(), coordinates.end());
  const flann::Matrix<double> queries(query.data(), 1, query.size());
  std::vector<std::vector<std::size_t>> indices;
  std::vector<std::vector<double>> distances;
  tree_->index.knnSearch(queries, indices, distances, max_count, exact_search());
  const auto reach = static_cast<float>(distances[0].back() * (1 + 1e-4) + 1e-12);
  tree_->index.radiusSearch(queries, indices, distances, reach, exact_search());

  std::vector<Neighbour> found;
  for (const std::size_t index : indices[0]) {
    found.push_back({static_cast<int>(index),
                     squared_distance(coordinates, &tree_->floats[index * query.size()])});
  }
  std::sort(found.begin(), found.end(), is_nearer);
  found.resize(std::min(found.size(), max_count));
  return found;
}

}  // namespace flinch::models
