// SPDX-License-Identifier: MIT
#include "models/knn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>
#include <limits>
#include <random>
#include <vector>

#include "models/fit/knn_fit.h"
#include "motion/error.h"
#include "tests/models/training_sets.h"
#include "tests/scenes/not_finite.h"

namespace flinch::models {
namespace {

/// Returns all observations, sorted by distance, computed one by one, then by index.
std::vector<Neighbour> all_sorted(const KnnModel& model, std::span<const double> query,
                                  const ClipMask& allowed) {
  std::vector<Neighbour> all;
  const auto count = static_cast<std::size_t>(model.feature_count);
  for (std::size_t i = 0; i < model.label.size(); ++i) {
    if (!allowed.empty() && !allowed[static_cast<std::size_t>(model.label[i])]) {
      continue;
    }
    float distance = 0;
    for (std::size_t f = 0; f < count; ++f) {
      const float difference = static_cast<float>(query[f]) - model.points[i * count + f];
      distance += difference * difference;
    }
    all.push_back({static_cast<int>(i), distance});
  }
  std::stable_sort(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance < b.squared_distance;
  });
  return all;
}

void expect_same(std::span<const Neighbour> found, std::span<const Neighbour> sorted, int k) {
  ASSERT_EQ(found.size(), std::min(sorted.size(), static_cast<std::size_t>(k)));
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].observation, sorted[i].observation) << "neighbour " << i;
    ASSERT_EQ(found[i].squared_distance, sorted[i].squared_distance) << "neighbour " << i;
  }
}

KnnModel random_model(std::uint64_t seed, int count, int features) {
  return fit_knn(random_clouds(seed, count, 8, features), {3, KnnVote::majority});
}

/// Points with few distinct coordinates: most distances are tied, many points are equal.
KnnModel model_of_ties(std::uint64_t seed, int count, int features) {
  KnnModel model = random_model(seed, count, features);
  for (float& value : model.points) {
    value = std::round(value);
  }
  build_leaves(model);
  return model;
}

TEST(Knn, FindsTheNearestAllowedObservations) {
  std::mt19937_64 random(1);
  for (const KnnModel& model : {random_model(2, 700, 5), model_of_ties(3, 700, 5)}) {
    for (int i = 0; i < 300; ++i) {
      const std::vector<double> query = random_point(random, 5);
      ClipMask allowed(16);
      for (std::size_t clip = 0; clip < allowed.size(); ++clip) {
        allowed[clip] = random() % 3 == 0;
      }
      const int k = 1 + static_cast<int>(random() % 30);
      expect_same(nearest(model, query, k, {}), all_sorted(model, query, {}), k);
      expect_same(nearest(model, query, k, allowed), all_sorted(model, query, allowed), k);
    }
  }
}

TEST(Knn, ReturnsFewerThanKIfThereAreFewer) {
  const KnnModel model = random_model(4, 20, 3);
  const std::vector<double> query{0, 0, 0};
  EXPECT_EQ(nearest(model, query, 50, {}).size(), 20U);
  EXPECT_TRUE(nearest(model, query, 3, ClipMask(16, false)).empty());
  EXPECT_TRUE(nearest(model, query, 0, {}).empty());
}

std::vector<double> doubles(const std::vector<float>& floats) {
  return {floats.begin(), floats.end()};
}

TEST(Knn, MatchesBruteForceForAnyNumberOfLeaves) {
  std::mt19937_64 random(15);
  for (const int count : {2, 15, 16, 17, 32, 255, 256, 257, 1000}) {
    for (const KnnModel& model : {random_model(16, count, 20), model_of_ties(17, count, 3)}) {
      for (int i = 0; i < 20; ++i) {
        const std::vector<double> query = random_point(random, model.feature_count);
        const int k = 1 + static_cast<int>(random() % 40);
        expect_same(nearest(model, query, k, {}), all_sorted(model, query, {}), k);
      }
    }
  }
}

TEST(Knn, HandlesAnyQuery) {
  const KnnModel model = random_model(18, 100, 3);
  for (const double value : {1e300, -1e300, tests::kInfinityDouble, std::nan("")}) {
    EXPECT_EQ(nearest(model, std::vector<double>{0, value, 0}, 5, {}).size(), 5U);
  }
}

TEST(NeighbourIndex, MatchesBruteForce) {
  std::mt19937_64 random(5);
  KnnModel same = random_model(6, 200, 4);
  std::fill(same.points.begin(), same.points.end(), 0.25F);
  for (const KnnModel& model :
       {random_model(7, 1500, 16), random_model(8, 300, 1), model_of_ties(9, 1500, 4), same}) {
    const NeighbourIndex tree(doubles(model.points), model.feature_count);
    for (int i = 0; i < 300; ++i) {
      std::vector<double> query = random_point(random, model.feature_count);
      if (i % 3 == 0) {  // on the grid of the ties, exactly between its points
        for (double& value : query) {
          value = std::round(2 * value) / 2;
        }
      }
      const int k = 1 + static_cast<int>(random() % 30);
      expect_same(tree.nearest(query, k), all_sorted(model, query, {}), k);
    }
    EXPECT_EQ(tree.nearest(random_point(random, model.feature_count), 5000).size(),
              model.label.size());
  }
}

// Every point has the same coordinates in a different order, so all are equally far from a query on
// the diagonal, except for the rounding of the sums, which depends on the order.
TEST(NeighbourIndex, OrdersDistancesThatDifferByRoundingAlone) {
  std::mt19937_64 random(13);
  KnnModel model = random_model(14, 1000, 16);
  const std::vector<double> coordinates = random_point(random, 16);
  for (auto row = model.points.begin(); row != model.points.end(); row += 16) {
    std::copy(coordinates.begin(), coordinates.end(), row);
    std::shuffle(row, row + 16, random);
  }
  build_leaves(model);
  const NeighbourIndex tree(doubles(model.points), 16);
  for (const int k : {1, 3, 10, 100}) {
    const std::vector<double> query(16, 1.0 / k);
    expect_same(tree.nearest(query, k), all_sorted(model, query, {}), k);
    expect_same(nearest(model, query, k, {}), all_sorted(model, query, {}), k);
  }
}

TEST(NeighbourIndex, IsEmptyForNoPoints) {
  EXPECT_TRUE(NeighbourIndex({}, 3).nearest(std::vector<double>{0, 0, 0}, 5).empty());
}

// FLANN used according to its manual, without our code: the distances equal ours.
TEST(Knn, DistancesMatchFlannBitForBit) {
  const KnnModel model = random_model(10, 1000, 16);
  std::vector<double> values = doubles(model.points);
  const flann::Matrix<double> points(values.data(), 1000, 16);
  flann::Index<flann::L2<double>> tree(points, flann::LinearIndexParams());
  tree.buildIndex();
  std::mt19937_64 random(11);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> query = random_point(random, 16);
    std::vector<std::vector<int>> indices;
    std::vector<std::vector<double>> distances;
    tree.knnSearch(flann::Matrix<double>(query.data(), 1, 16), indices, distances, 10,
                   flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
    const auto found = nearest(model, query, 10, {});
    for (std::size_t n = 0; n < 10; ++n) {
      ASSERT_EQ(found[n].observation, indices[0][n]);
      ASSERT_NEAR(found[n].squared_distance, distances[0][n], 1e-5);
    }
  }
}

std::vector<int> clips_of(std::span<const Candidate> candidates) {
  std::vector<int> clips;
  for (const Candidate& candidate : candidates) {
    clips.push_back(candidate.clip);
  }
  return clips;
}

TEST(KnnVotes, MajorityCountsEachNeighbourOnce) {
  const std::vector<int> label{4, 9, 9, 2};
  const std::vector<Neighbour> neighbours{{0, 0.01F}, {1, 4}, {2, 9}, {3, 16}};
  const auto ranked = count_votes(neighbours, label, KnnVote::majority);
  EXPECT_THAT(clips_of(ranked), testing::ElementsAre(9, 4, 2));  // 4 is nearer than 2
  EXPECT_FLOAT_EQ(ranked[0].vote, 0.5F);
  EXPECT_FLOAT_EQ(ranked[1].vote, 0.25F);
}

TEST(KnnVotes, InverseDistanceWeightsNearNeighboursMore) {
  const std::vector<int> label{4, 9, 9, 2};
  const std::vector<Neighbour> neighbours{{0, 0.25}, {1, 4}, {2, 16}, {3, 16}};
  const auto ranked = count_votes(neighbours, label, KnnVote::inverse_distance);
  // Votes: 1/0.5 = 2 for clip 4; 1/2 + 1/4 = 0.75 for clip 9; 0.25 for clip 2.
  EXPECT_THAT(clips_of(ranked), testing::ElementsAre(4, 9, 2));
  EXPECT_NEAR(ranked[0].vote, 2.0 / 3.0, 1e-5);
  EXPECT_NEAR(ranked[1].vote, 0.25, 1e-5);
  EXPECT_NEAR(ranked[2].vote, 0.25 / 3.0, 1e-5);
}

TEST(KnnVotes, TheSamePointWinsOverAllOthers) {
  const std::vector<int> label{1, 2, 2, 2};
  const std::vector<Neighbour> neighbours{{0, 0}, {1, 1e-4F}, {2, 1e-4F}, {3, 1e-4F}};
  EXPECT_EQ(count_votes(neighbours, label, KnnVote::inverse_distance).front().clip, 1);
}

/// Observations at 0, 1, 2 with the costs of four clips: the third was tried on the last
/// observation only, the fourth on none.
TrainingSet three_with_costs() {
  constexpr float kUntried = std::numeric_limits<float>::infinity();
  TrainingSet set = make_set(1, {0, 1, 2}, {0, 1, 2}, 4);
  set.cost = {1, 4, kUntried, kUntried,  //
              3, 2, kUntried, kUntried,  //
              8, 6, 0.5F,     kUntried};
  return set;
}

TEST(KnnCosts, AreAveragedOverTheNeighboursThatTriedTheClip) {
  const KnnModel model = fit_knn(three_with_costs(), {2, KnnVote::cost});
  const std::vector<Neighbour> neighbours{{1, 0}, {2, 1}};
  const auto all = average_costs(neighbours, model, ClipMask(4, true));
  EXPECT_THAT(clips_of(all), testing::ElementsAre(2, 1, 0));
  EXPECT_NEAR(all[0].expected_cost_ns, 0.5, 2e-4);
  EXPECT_NEAR(all[1].expected_cost_ns, 4, 2e-4);
  EXPECT_NEAR(all[2].expected_cost_ns, 5.5, 2e-4);
  ClipMask allowed(4, true);
  allowed[2] = false;
  EXPECT_THAT(clips_of(average_costs(neighbours, model, allowed)), testing::ElementsAre(1, 0));
  EXPECT_TRUE(average_costs({}, model, allowed).empty());
}

TEST(KnnCosts, AreQuantisedToHalfAStep) {
  const TrainingSet set = with_costs(random_clouds(19, 200, 8, 5), 20);
  const KnnModel model = fit_knn(set, {1, KnnVote::cost});
  const float max_cost = *std::max_element(set.cost.begin(), set.cost.end());
  EXPECT_NEAR(model.cost_step_ns, max_cost / 65534, 1e-6 * max_cost);
  for (std::size_t i = 0; i < set.cost.size(); ++i) {
    ASSERT_NE(model.cost[i], KnnModel::kUntried);
    ASSERT_NEAR(model.cost[i] * model.cost_step_ns, set.cost[i], 0.51 * model.cost_step_ns);
  }
  TrainingSet free = three_with_costs();
  free.cost.assign(free.cost.size(), 0);
  EXPECT_EQ(average_costs(std::vector<Neighbour>{{0, 0}}, fit_knn(free, {1, KnnVote::cost}),
                          ClipMask(4, true))
                .front()
                .expected_cost_ns,
            0);
}

TEST(KnnFit, RefusesInvalidInput) {
  const TrainingSet set = random_clouds(12, 10, 2, 3);
  EXPECT_THROW(fit_knn(set, {1, KnnVote::cost}), Error);  // the set has no costs
  EXPECT_THROW(fit_knn(set, {1001, KnnVote::majority}), Error);
  for (const float cost : {-1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    TrainingSet wrong = three_with_costs();
    wrong.cost[5] = cost;
    EXPECT_THROW(fit_knn(wrong, {1, KnnVote::cost}), Error);
  }
  TrainingSet untried = three_with_costs();
  std::fill_n(untried.cost.begin(), 4, std::numeric_limits<float>::infinity());
  EXPECT_THROW(fit_knn(untried, {1, KnnVote::cost}), Error);
  EXPECT_THROW(fit_knn(set, {0, KnnVote::majority}), Error);
  EXPECT_THROW(fit_knn(make_set(1, {1}, {0}, 1), {1, KnnVote::majority}), Error);
}

}  // namespace
}  // namespace flinch::models
