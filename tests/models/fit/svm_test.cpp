// SPDX-License-Identifier: MIT
#include "models/svm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "models/pair_index.h"
#include "tests/models/fit/libsvm_oracle.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

int predicted_label(const SvmModel& model, std::span<const double> point) {
  return model.label[static_cast<std::size_t>(predict(model, point))];
}

/// Checks that our model and libsvm's, trained on the same set, agree on every point of the set, on
/// the origin and on random points inside and outside the range of the features.
void expect_predictions_of_libsvm(const TrainingSet& set, const SvmParameters& parameters) {
  const LibsvmOracle oracle(set, parameters);
  const SvmModel model = fit_svm(set, parameters);
  for (int i = 0; i < set.size(); ++i) {
    ASSERT_EQ(predicted_label(model, set.point(i)), oracle.predict(set.point(i))) << "point " << i;
  }
  std::vector<double> point(static_cast<std::size_t>(set.feature_count), 0.0);
  ASSERT_EQ(predicted_label(model, point), oracle.predict(point)) << "origin";
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    point = random_point(random, set.feature_count);
    if (i % 2 == 1) {
      for (double& value : point) {
        value *= 10;
      }
    }
    ASSERT_EQ(predicted_label(model, point), oracle.predict(point)) << "random point " << i;
  }
}

const std::vector<SvmParameters> kKernels{
    {.degree = 3, .gamma = 0.5, .coef0 = 1, .cost = 10},
    {.degree = 2, .gamma = 0.2, .coef0 = 0, .cost = 1},
    {.gamma = 0.3, .cost = 1, .kernel = SvmKernel::rbf},
    {.gamma = 2, .cost = 100, .kernel = SvmKernel::rbf},
    {.gamma = 0.3, .cost = 1, .kernel = SvmKernel::rbf, .balance = 0.5},
};

TEST(Svm, PredictsLibsvmsLabelsForRandomProblems) {
  std::uint64_t seed = 1;
  for (const int classes : {2, 3, 7, 30}) {
    for (const int degree : {1, 2, 3, 5}) {
      for (const double coef0 : {0.0, 1.0}) {
        SCOPED_TRACE(testing::Message() << classes << " classes, degree " << degree);
        const int features = 1 + static_cast<int>(seed % 17);
        const TrainingSet set = random_clouds(seed++, 200, classes, features);
        expect_predictions_of_libsvm(set, {degree, 1.0 / features, coef0, 10});
        expect_predictions_of_libsvm(
            set, {.gamma = (1 + coef0) / degree, .cost = 10, .kernel = SvmKernel::rbf});
      }
    }
  }
}

TEST(Svm, PredictsLibsvmsLabelsForDegenerateProblems) {
  const SvmParameters parameters{3, 0.5, 0, 1};
  {
    SCOPED_TRACE("one class");
    expect_predictions_of_libsvm(make_set(2, {1, 2, 3, 4}, {5, 5}, 6), parameters);
  }
  {
    SCOPED_TRACE("one point a class");
    expect_predictions_of_libsvm(make_set(2, {1, 0, 0, 1, -1, 0}, {2, 0, 1}, 3), parameters);
  }
  {
    SCOPED_TRACE("all points the origin");
    expect_predictions_of_libsvm(make_set(3, std::vector<double>(12, 0.0), {0, 1, 2, 1}, 3),
                                 parameters);
  }
  {
    SCOPED_TRACE("the same point under different labels");
    expect_predictions_of_libsvm(make_set(2, {1, 1, 1, 1, 1, 1, -1, 0}, {0, 1, 2, 0}, 3),
                                 parameters);
  }
  {
    SCOPED_TRACE("features that never vary, symmetric classes");
    expect_predictions_of_libsvm(
        make_set(3, {0, 1, 0, 0, -1, 0, 0, 1, 1, 0, -1, -1}, {0, 1, 0, 1}, 2), parameters);
  }
}

/// Sorts the allowed classes by votes, ties by the lower index.
std::vector<std::pair<std::size_t, int>> sorted(const std::vector<int>& votes,
                                                std::span<const char> allowed) {
  std::vector<std::pair<std::size_t, int>> ranked;
  for (std::size_t c = 0; c < votes.size(); ++c) {
    if (allowed[c]) ranked.emplace_back(c, votes[c]);
  }
  std::ranges::stable_sort(ranked, std::greater<>(), [](const auto& one) { return one.second; });
  return ranked;
}

TEST(Svm, RanksAllowedClassesAsLibsvmsVotesDo) {
  std::mt19937_64 random(9);
  for (const SvmParameters& parameters : kKernels) {
    const TrainingSet set = random_clouds(3, 300, 24, 6);
    const LibsvmOracle oracle(set, parameters);
    const SvmModel model = fit_svm(set, parameters);
    const auto classes = static_cast<std::size_t>(model.class_count());
    ASSERT_EQ(classes, 24U);
    for (int i = 0; i < 1500; ++i) {
      const std::vector<double> point = random_point(random, 6);
      std::vector<char> allowed(classes);
      for (char& one : allowed) one = i % 3 == 0 || random() % 3 == 0;
      const auto expected = sorted(oracle.votes(point, allowed), allowed);
      const auto ranked = rank(model, point, allowed);
      ASSERT_EQ(ranked.size(), expected.size());
      for (std::size_t k = 0; k < ranked.size(); ++k) {
        ASSERT_EQ(ranked[k].index, expected[k].first) << "case " << i << ", place " << k;
        ASSERT_EQ(ranked[k].votes, expected[k].second) << "case " << i << ", place " << k;
      }
      for (const std::size_t max_count : {1U, 2U, 5U}) {
        const auto first = rank(model, point, allowed, max_count);
        ASSERT_EQ(first.size(), std::min(max_count, ranked.size()));
        for (std::size_t k = 0; k < first.size(); ++k) {
          ASSERT_EQ(first[k].index, ranked[k].index) << "case " << i << ", place " << k;
          ASSERT_EQ(first[k].votes, ranked[k].votes) << "case " << i << ", place " << k;
        }
      }
    }
  }
}

TEST(Svm, ATieOfVotesGoesToTheLowerClipWhicheverWasSeenFirst) {
  const TrainingSet set = random_clouds(6, 300, 10, 4);
  std::vector<int> backwards(set.label.size());
  std::iota(backwards.rbegin(), backwards.rend(), 0);
  const std::vector<char> all(10, 1);
  for (const TrainingSet& seen : {set, subset(set, backwards)}) {
    const SvmModel model = fit_svm(seen, kKernels.front());
    std::mt19937_64 random(12);
    int ties = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::vector<double> point = random_point(random, 4);
      const auto ranked = rank(model, point, all);
      int lowest = predicted_label(model, point);
      std::size_t tied = 0;
      for (; tied < ranked.size() && ranked[tied].votes == ranked[0].votes; ++tied)
        lowest = std::min(lowest, model.label[ranked[tied].index]);
      ASSERT_EQ(predicted_label(model, point), lowest) << "point " << i;
      if (tied > 1) ++ties;
    }
    EXPECT_GT(ties, 40);
  }
}

TEST(Svm, DecisionValuesMatchLibsvmBitForBit) {
  std::mt19937_64 random(10);
  for (const SvmParameters& parameters : kKernels) {
    const TrainingSet set = random_clouds(4, 300, 8, 5);
    const LibsvmOracle oracle(set, parameters);
    const SvmModel model = fit_svm(set, parameters);
    for (int i = 0; i < 200; ++i) {
      const std::vector<double> point = random_point(random, 5);
      const std::vector<double> expected = oracle.decisions(point);
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = a + 1; b < 8; ++b) {
          ASSERT_EQ(decision_value(model, point, a, b),
                    expected[pair_index(a, b, model.label.size())]);
        }
      }
    }
  }
}

/// Near a boundary, float precision cannot decide: the decision value is little more than rounding
/// errors of double.
TEST(Svm, MatchesLibsvmNearDecisionBoundaries) {
  const SvmParameters parameters{.degree = 3, .gamma = 0.5, .coef0 = 1, .cost = 10};
  const TrainingSet set = random_clouds(5, 200, 6, 4);
  const LibsvmOracle oracle(set, parameters);
  const SvmModel model = fit_svm(set, parameters);
  const std::vector<char> all(6, 1);
  std::mt19937_64 random(11);
  int near = 0;
  for (int i = 0; i < 400; ++i) {
    // Bisects between a point that class 0 wins against class 1 and one that it loses.
    std::vector<double> inside = random_point(random, 4);
    std::vector<double> outside = random_point(random, 4);
    if ((decision_value(model, inside, 0, 1) > 0) == (decision_value(model, outside, 0, 1) > 0))
      continue;
    const bool side = decision_value(model, inside, 0, 1) > 0;
    for (int step = 0; step < 60; ++step) {
      std::vector<double> middle(4);
      for (std::size_t f = 0; f < 4; ++f) middle[f] = (inside[f] + outside[f]) / 2;
      ((decision_value(model, middle, 0, 1) > 0) == side ? inside : outside) = middle;
    }
    for (const std::vector<double>& point : {inside, outside}) {
      const auto expected = sorted(oracle.votes(point, all), all);
      const auto ranked = rank(model, point, all);
      for (std::size_t k = 0; k < ranked.size(); ++k) {
        ASSERT_EQ(ranked[k].index, expected[k].first);
        ASSERT_EQ(ranked[k].votes, expected[k].second);
      }
      ASSERT_EQ(predicted_label(model, point), oracle.predict(point));
      ++near;
    }
  }
  EXPECT_GT(near, 100);
}

}  // namespace
}  // namespace flinch::models
