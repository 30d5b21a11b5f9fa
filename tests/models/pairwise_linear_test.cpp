// SPDX-License-Identifier: MIT
#include "models/pairwise_linear.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "models/selector.h"
#include "tests/models/training_sets.h"
#include "tests/scenes/not_finite.h"

namespace flinch::models {
namespace {

/// Random machines for most pairs of classes; class c is clip 2 c + 1.
PairwiseModel random_machines(std::uint64_t seed, int features, std::size_t classes) {
  std::mt19937_64 random(seed);
  PairwiseModel model;
  model.feature_count = features;
  for (std::size_t c = 0; c < classes; ++c) model.clip.push_back(2 * static_cast<int>(c) + 1);
  int machines = 0;
  for (std::size_t pair = 0; pair < classes * (classes - 1) / 2; ++pair) {
    model.machine.push_back(random() % 10 == 0 ? PairwiseModel::kNone : machines++);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(machines) * model.row_size(); ++i) {
    model.weights.push_back(static_cast<std::int16_t>(static_cast<int>(random() % 2001) - 1000));
  }
  return model;
}

/// Returns the decision value of a machine, from products of features in double precision.
double reference_decision(const PairwiseModel& model, const std::vector<double>& x, int machine) {
  std::vector<double> z{1};
  z.insert(z.end(), x.begin(), x.end());
  std::size_t at = static_cast<std::size_t>(machine) * model.row_size();
  double sum = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (std::size_t j = i; j < z.size(); ++j) sum += z[i] * z[j] * model.weights[at++];
  }
  return sum;
}

/// Multiples of 1/32: their products are exact terms, so the reference is exact.
std::vector<double> exact_point(std::mt19937_64& random, int features) {
  std::vector<double> x = random_point(random, features);
  for (double& value : x) value = std::round(value * 32) / 32;
  return x;
}

/// Ranks by the decisions of all pairs of allowed classes, in the order of `machine`.
std::vector<Candidate> reference_ranking(const PairwiseModel& model, const std::vector<double>& x,
                                         const ClipMask& allowed) {
  std::vector<int> wins(model.clip.size());
  std::size_t pair = 0;
  int pairs = 0;
  const auto is_allowed = [&](std::size_t c) {
    return bool{allowed[static_cast<std::size_t>(model.clip[c])]};
  };
  for (std::size_t a = 0; a < wins.size(); ++a) {
    for (std::size_t b = a + 1; b < wins.size(); ++b, ++pair) {
      if (!is_allowed(a) || !is_allowed(b)) continue;
      const int machine = model.machine[pair];
      const bool first = machine < 0 || reference_decision(model, x, machine) >= 0;
      ++wins[first ? a : b];
      ++pairs;
    }
  }
  std::vector<Candidate> ranked;
  for (std::size_t c = 0; c < wins.size(); ++c) {
    if (is_allowed(c)) ranked.push_back({model.clip[c], static_cast<float>(wins[c])});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Candidate& a, const Candidate& b) { return a.vote > b.vote; });
  for (Candidate& each : ranked)
    each.vote = pairs == 0 ? 1.0F : each.vote / static_cast<float>(pairs);
  return ranked;
}

TEST(PairwiseLinear, RankingIsIndependentOfTheRequestedCount) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    const int features = 1 + static_cast<int>(random() % 6);
    const PairwiseModel model = random_machines(random(), features, 1 + random() % 12);
    const std::vector<double> x = exact_point(random, features);
    ClipMask allowed(24);
    for (std::size_t clip = 0; clip < allowed.size(); ++clip) allowed[clip] = random() % 4 != 0;
    const std::vector<Candidate> expected = reference_ranking(model, x, allowed);
    for (std::size_t max_count = 0; max_count <= expected.size() + 1; ++max_count) {
      const auto ranked = rank(model, x, allowed, max_count);
      ASSERT_EQ(ranked.size(), std::min(max_count, expected.size()));
      for (std::size_t i = 0; i < ranked.size(); ++i) {
        ASSERT_EQ(ranked[i].clip, expected[i].clip);
        ASSERT_EQ(ranked[i].vote, expected[i].vote);
        ASSERT_TRUE(std::isnan(ranked[i].expected_cost_ns));
      }
    }
  }
}

TEST(PairwiseLinear, TiesGoToTheFirstClass) {
  PairwiseModel model;
  model.feature_count = 1;
  model.clip = {3, 5};
  model.machine = {0};
  model.weights.assign(model.row_size(), 0);
  std::vector<std::int16_t> terms(model.row_size());
  expand(std::vector{0.5}, terms);
  EXPECT_TRUE(beats(model, terms, 0, 1));
  model.weights[0] = -1;
  EXPECT_FALSE(beats(model, terms, 0, 1));
}

TEST(PairwiseLinear, TermsAreTheProductsInOrder) {
  std::vector<std::int16_t> terms(PairwiseModel::row_size(2), 99);
  ASSERT_EQ(terms.size(), 16U);
  expand(std::vector{0.5, -1.25}, terms);
  EXPECT_THAT(
      terms, testing::ElementsAre(1024, 512, -1280, 256, -640, 1600, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(PairwiseModel::term_count(16), 153U);
}

TEST(PairwiseLinear, SumsNeverOverflow) {
  PairwiseModel model = random_machines(2, features::kMaxFeatures, 2);
  model.machine = {0};
  const std::size_t terms = PairwiseModel::term_count(features::kMaxFeatures);
  model.weights.assign(model.row_size(), 0);
  const auto max_count = static_cast<std::int16_t>(PairwiseModel::kMaxWeightSum / 100);
  std::fill_n(model.weights.begin(), 100, max_count);
  ASSERT_GT(terms, 100U);
  const auto first_wins = [&](double value) {
    const std::vector<double> x(features::kMaxFeatures, value);
    return rank(model, x, ClipMask(4, true), 1)[0].clip == 1;
  };
  EXPECT_TRUE(first_wins(2));
  EXPECT_TRUE(first_wins(tests::kInfinityDouble));
  EXPECT_TRUE(first_wins(1e300));
  for (std::int16_t& weight : model.weights) weight = static_cast<std::int16_t>(-weight);
  EXPECT_FALSE(first_wins(2));
  EXPECT_FALSE(first_wins(tests::kInfinityDouble));
  // NaN counts as far below.
  EXPECT_EQ(first_wins(std::nan("")), first_wins(-tests::kInfinityDouble));
}

TEST(PairwiseLinear, FallsBackToIdleWithoutAnAllowedClip) {
  const PairwiseModel model = random_machines(3, 2, 3);
  const std::vector<double> x{0, 0};
  ClipMask allowed(7);
  allowed[6] = true;
  auto ranked = candidates(model, x, allowed, 6);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 6);
  EXPECT_EQ(ranked[0].vote, 0);
  allowed[3] = true;
  ranked = candidates(model, x, allowed, 6);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 3);
  EXPECT_EQ(ranked[0].vote, 1);
  // A request for zero candidates still returns the choice.
  ranked = candidates(model, x, allowed, 6, std::pmr::get_default_resource(), 0);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 3);
}

}  // namespace
}  // namespace flinch::models
