// SPDX-License-Identifier: MIT
#include "models/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/selector.h"
#include "tests/models/network_reference.h"
#include "tests/models/training_sets.h"
#include "tests/scenes/not_finite.h"

namespace flinch::models {
namespace {

/// Makes a network with random weights and an output for every other clip.
NetworkModel random_network(std::uint64_t seed, int features, int hidden, int outputs,
                            int members) {
  std::mt19937_64 random(seed);
  NetworkModel model;
  model.feature_count = features;
  model.hidden_count = hidden;
  model.member_count = members;
  for (int i = 0; i < outputs; ++i) {
    model.clip.push_back(2 * i + 1);
  }
  model.mean_root = 2;
  model.scale_root = 0.25F;
  model.variance_ns = 0.125F;
  for (std::size_t i = 0; i < model.shape().weight_count() * static_cast<std::size_t>(members);
       ++i) {
    model.weights.push_back(static_cast<float>(random_point(random, 1)[0]) / 2);
  }
  return model;
}

TEST(Network, MatchesItsEquations) {
  std::mt19937_64 random(1);
  for (const int members : {1, 3}) {
    const NetworkModel model = random_network(2, 5, 32, 7, members);
    for (int i = 0; i < 50; ++i) {
      const std::vector<double> x = random_point(random, 5);
      const auto ranked = expected_costs(model, x, ClipMask(14, true));
      ASSERT_EQ(ranked.size(), 7U);
      std::vector<double> answers(7);
      for (int member = 0; member < members; ++member) {
        const std::size_t count = model.shape().weight_count();
        const auto own =
            std::span(model.weights).subspan(static_cast<std::size_t>(member) * count, count);
        const auto each = reference_outputs(model.shape(), {own.begin(), own.end()}, x);
        for (std::size_t output = 0; output < 7; ++output) {
          answers[output] += each[output] / members;
        }
      }
      for (std::size_t place = 0; place < 7; ++place) {
        const double root = 2 + 0.25 * answers[static_cast<std::size_t>(ranked[place].clip / 2)];
        ASSERT_NEAR(ranked[place].expected_cost_ns, std::pow(std::max(root, 0.0), 2) + 0.125, 1e-4);
        ASSERT_EQ(ranked[place].vote, 0);
        ASSERT_TRUE(place == 0 ||
                    ranked[place - 1].expected_cost_ns <= ranked[place].expected_cost_ns);
      }
    }
  }
}

TEST(Network, ForbiddenClipsDoNotChangeTheRanking) {
  std::mt19937_64 random(3);
  const NetworkModel model = random_network(4, 6, 16, 9, 2);
  for (int i = 0; i < 50; ++i) {
    const std::vector<double> x = random_point(random, 6);
    ClipMask allowed(18);
    for (std::size_t clip = 0; clip < allowed.size(); ++clip) {
      allowed[clip] = random() % 2 == 0;
    }
    std::vector<std::pair<int, float>> expected;
    for (const Candidate& candidate : expected_costs(model, x, ClipMask(18, true))) {
      if (allowed[static_cast<std::size_t>(candidate.clip)]) {
        expected.emplace_back(candidate.clip, candidate.expected_cost_ns);
      }
    }
    std::vector<std::pair<int, float>> found;
    for (const Candidate& candidate : expected_costs(model, x, allowed)) {
      found.emplace_back(candidate.clip, candidate.expected_cost_ns);
    }
    ASSERT_EQ(found, expected);
  }
}

TEST(Network, TiesGoToTheLowerClipAndIdleIsTheFallback) {
  NetworkModel model = random_network(5, 3, 16, 4, 1);
  std::fill(model.weights.begin(), model.weights.end(), 0.0F);
  const std::vector<double> x(3);
  const auto ranked = expected_costs(model, x, ClipMask(8, true));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(ranked[i].clip, 2 * static_cast<int>(i) + 1);
    EXPECT_EQ(ranked[i].expected_cost_ns, 4.125F);
  }
  ClipMask unknown(8, false);
  unknown[0] = unknown[2] = true;
  const auto last_resort = candidates(model, x, unknown, 2);
  ASSERT_EQ(last_resort.size(), 1U);
  EXPECT_EQ(last_resort[0].clip, 2);
  EXPECT_TRUE(std::isnan(last_resort[0].expected_cost_ns));
}

TEST(Network, IsFiniteForAnyInput) {
  NetworkModel model = random_network(6, 40, 64, 5, 2);
  for (float& weight : model.weights) weight = std::copysign(kMaxNetworkWeight, weight);
  for (const double value :
       {1e300, -1e300, tests::kInfinityDouble, -tests::kInfinityDouble, std::nan("")}) {
    for (const Candidate& candidate :
         expected_costs(model, std::vector<double>(40, value), ClipMask(10, true))) {
      EXPECT_TRUE(std::isfinite(candidate.expected_cost_ns));
    }
  }
  EXPECT_EQ(network_input(1.5), 1.5F);
  EXPECT_EQ(network_input(-7), -2.0F);
  EXPECT_EQ(network_input(std::nan("")), -2.0F);
}

TEST(Network, RanksTheFirstAsAmongAll) {
  std::mt19937_64 random(7);
  const NetworkModel model = random_network(4, 6, 48, 9, 2);
  const std::vector<double> x = random_point(random, 6);
  const auto all = expected_costs(model, x, ClipMask(18, true));
  for (std::size_t most = 0; most <= all.size() + 1; ++most) {
    const auto first =
        expected_costs(model, x, ClipMask(18, true), std::pmr::get_default_resource(), most);
    ASSERT_EQ(first.size(), std::min(most, all.size()));
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i].clip, all[i].clip);
      EXPECT_EQ(first[i].expected_cost_ns, all[i].expected_cost_ns);
    }
  }
}

}  // namespace
}  // namespace flinch::models
