// SPDX-License-Identifier: MIT
#include "runtime/push/push_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "models/realism_query.h"
#include "motion/rotation.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/push/push_scene.h"

namespace flinch::runtime {
namespace {

using models::RealismFeatures;

RealismFeatures random_features(std::mt19937& random, float reach) {
  RealismFeatures features;
  const auto fill = [&](auto& numbers) {
    for (float& number : numbers) number = tests::uniform(random, -reach, reach);
  };
  fill(features.character);
  fill(features.response);
  fill(features.deformation);
  fill(features.asked);
  features.log_taper = tests::uniform(random, 0, reach);
  features.turn = tests::uniform(random, -reach, reach);
  return features;
}

/// Gives every example one of `responses` responses, as the examples of a library have.
models::RealismModel with_shared_responses(models::RealismModel model, std::size_t responses) {
  const std::size_t count = model.size();
  for (std::size_t k = models::kConfigurationComponents; k < 2 * models::kConfigurationComponents;
       ++k) {
    for (std::size_t i = responses; i < count; ++i)
      model.points[k * count + i] = model.points[k * count + i % responses];
  }
  return model;
}

TEST(RealismQuery, EqualsTheComparisonWithEveryExample) {
  struct Size {
    std::size_t examples;
    std::size_t responses;
  };
  std::mt19937 random(1);
  int zeros = 0;
  for (const auto [count, responses] :
       {Size{10, 10}, Size{31, 31}, Size{400, 400}, Size{31, 3}, Size{400, 1}, Size{700, 30}}) {
    const models::RealismModel model = with_shared_responses(
        tests::random_realism(static_cast<unsigned>(count), count), responses);
    ASSERT_TRUE(models::is_sound(model));
    const models::RealismIndex index(model);
    std::vector<float> memory(models::RealismQuery::memory_size(index));
    for (int round = 0; round < 40; ++round) {
      const RealismFeatures base = random_features(random, 2);
      models::RealismQuery query(index, base, memory);
      for (int candidate = 0; candidate < 5; ++candidate) {
        RealismFeatures features = random_features(random, candidate == 0 ? 9.0F : 2.0F);
        features.character = base.character;
        features.asked = base.asked;
        const std::array log_tapers{0.0F, 1.5F, 4.0F, -3.0F, 9.0F};
        std::array<float, 5> estimates{};
        query.estimate(features, log_tapers, estimates);
        for (std::size_t t = 0; t < log_tapers.size(); ++t) {
          features.log_taper = log_tapers[t];
          const float expected = models::estimate_realism(model, features);
          EXPECT_NEAR(estimates[t], expected, 1e-4F);
          zeros += expected == 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(zeros, 10) << "far from every example the estimate is 0";
}

TEST(RealismQuery, OfExamplesEquallyFarTheFirstTenCount) {
  models::RealismModel model = tests::random_realism(4, 40);
  for (std::size_t k = 0; k < models::kRealismFeatureCount; ++k)
    std::fill_n(model.points.begin() + static_cast<std::ptrdiff_t>(k * model.size()), model.size(),
                model.points[k * model.size()]);
  model.max_distance = 1000;
  const float mean = std::accumulate(model.quality.begin(), model.quality.begin() + 10, 0.0F) / 10;
  std::mt19937 random(6);
  RealismFeatures features = random_features(random, 2);
  const models::RealismIndex index(model);
  std::vector<float> memory(models::RealismQuery::memory_size(index));
  models::RealismQuery query(index, features, memory);
  const std::array log_tapers{0.0F, 1.0F, 2.0F, 3.0F, 4.0F};
  std::array<float, 5> estimates{};
  query.estimate(features, log_tapers, estimates);
  for (const float estimate : estimates) EXPECT_NEAR(estimate, mean, 1e-5F);
  EXPECT_NEAR(models::estimate_realism(model, features), mean, 1e-5F);
}

models::ThetaExamples random_theta(std::mt19937& random, std::size_t count) {
  models::ThetaExamples examples;
  for (float& weight : examples.weight) weight = tests::uniform(random, 0.5F, 2);
  for (std::size_t i = 0; i < count * models::kImpulseFeatureCount; ++i)
    examples.points.push_back(tests::uniform(random, -2, 2));
  for (std::size_t i = 0; i < count * models::kThetaSize; ++i)
    examples.theta.push_back(tests::uniform(random, -1, 1));
  return examples;
}

models::ImpulseFeatures random_impulse(std::mt19937& random) {
  models::ImpulseFeatures features;
  for (float& x : features.response) x = tests::uniform(random, -1, 1);
  for (float& x : features.place) x = tests::uniform(random, -1, 1);
  for (float& x : features.velocity) x = tests::uniform(random, -1, 1);
  return features;
}

/// All examples sorted by their distance, in double.
std::array<double, models::kThetaSize> theta_by_sorting(const models::ThetaExamples& examples,
                                                        const models::ImpulseFeatures& features) {
  std::vector<double> x(features.response.begin(), features.response.end());
  x.insert(x.end(), features.place.begin(), features.place.end());
  x.insert(x.end(), features.velocity.begin(), features.velocity.end());
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (std::size_t i = 0; i < examples.theta.size() / 4; ++i) {
    double squared = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
      squared += std::pow(
          double{examples.weight[k]} * x[k] - double{examples.points[x.size() * i + k]}, 2);
    by_distance.emplace_back(std::sqrt(squared), i);
  }
  std::ranges::sort(by_distance);
  std::array<double, models::kThetaSize> mean{};
  double weights = 0;
  for (std::size_t n = 0; n < 10; ++n) weights += 1 / by_distance[n].first;
  for (std::size_t n = 0; n < 10; ++n) {
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] +=
          double{examples.theta[4 * by_distance[n].second + k]} / (by_distance[n].first * weights);
  }
  return mean;
}

TEST(EstimateTheta, EqualsTheMeanOfTheTenNearestOfAllSorted) {
  std::mt19937 random(8);
  for (const std::size_t count : {10U, 11U, 60U, 500U}) {
    const models::ThetaExamples examples = random_theta(random, count);
    for (int round = 0; round < 30; ++round) {
      const models::ImpulseFeatures features = random_impulse(random);
      const models::Theta found = models::estimate_theta(examples, features);
      const auto expected = theta_by_sorting(examples, features);
      for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(double{found[k]}, expected[k], 1e-5);
    }
  }
}

TEST(EstimateTheta, OfExamplesEquallyFarTheFirstTenCount) {
  std::mt19937 random(11);
  models::ThetaExamples examples = random_theta(random, 40);
  std::ranges::fill(examples.points, 0.5F);
  const models::Theta found = models::estimate_theta(examples, random_impulse(random));
  for (std::size_t k = 0; k < found.size(); ++k) {
    float mean = 0;
    for (std::size_t i = 0; i < 10; ++i) mean += examples.theta[4 * i + k] / 10;
    EXPECT_NEAR(found[k], mean, 1e-5F);
  }
}

TEST(EstimateTheta, IsTheExamplesOwnWhereItStands) {
  std::mt19937 random(9);
  models::ThetaExamples examples = random_theta(random, 40);
  const models::ImpulseFeatures features = random_impulse(random);
  const auto all = models::as_array(features);
  for (std::size_t k = 0; k < all.size(); ++k)
    examples.points[all.size() * 23 + k] = examples.weight[k] * all[k];
  const models::Theta found = models::estimate_theta(examples, features);
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], examples.theta[4 * 23 + k], 1e-2F);
}

TEST(EstimateRealism, IsTheExamplesOwnWhereItStandsAndZeroFarAway) {
  models::RealismModel model = tests::random_realism(3, 50);
  std::mt19937 random(2);
  const RealismFeatures features = random_features(random, 1);
  const auto all = models::as_array(features);
  for (std::size_t k = 0; k < all.size(); ++k)
    model.points[k * model.size() + 17] = model.weight[k] * all[k];
  EXPECT_NEAR(models::estimate_realism(model, features), model.quality[17], 1e-3F);
  RealismFeatures far = features;
  far.turn += 100;
  EXPECT_EQ(models::estimate_realism(model, far), 0);
}

TEST(RealismModel, BrokenOnesAreNotSound) {
  const auto sound = tests::random_realism(1, 20);
  const auto broken = [&](auto change) {
    models::RealismModel model = sound;
    change(model);
    return models::is_sound(model);
  };
  EXPECT_FALSE(broken([](auto& m) { m.points.pop_back(); }));
  EXPECT_FALSE(broken([](auto& m) { m.basis.pop_back(); }));
  EXPECT_FALSE(broken([](auto& m) { m.quality[3] = 1.1F; }));
  EXPECT_FALSE(broken([](auto& m) { m.weight[3] = std::nanf(""); }));
  EXPECT_FALSE(broken([](auto& m) { m.max_distance = -1; }));
  std::mt19937 random(3);
  const models::ThetaExamples theta = random_theta(random, 20);
  EXPECT_TRUE(broken([&](auto& m) { m.theta = theta; }));  // which is sound
  EXPECT_FALSE(broken([&](auto& m) {
    m.theta = theta;
    m.theta->points.pop_back();
  }));
  EXPECT_FALSE(broken([&](auto& m) {
    m.theta = theta;
    m.theta->theta.pop_back();
  }));
  EXPECT_FALSE(broken([&](auto& m) {
    m.theta = theta;
    m.theta->theta[5] = std::nanf("");
  }));
  EXPECT_FALSE(broken([&](auto& m) {
    m.theta = theta;
    m.theta->weight[5] = std::numeric_limits<float>::infinity();
  }));
  EXPECT_FALSE(broken([](auto& m) {
    m.quality.resize(5);
    m.points.resize(5 * models::kRealismFeatureCount);
  }));
}

/// What a search finds for a push at the head, with this model.
struct HeadSearch {
  explicit HeadSearch(const models::RealismModel& of) : realism(of) {
    const BodyConfiguration& now = scene.responses.responses[2].configuration;
    character = models::components_of(realism, std::span(now.data(), realism.mean.size()));
    std::vector<std::byte> memory(model.memory_bytes);
    count = search_push(scene.responses, model, now, motion::Role::head, asked, {}, memory, best);
  }

  const tests::PushScene scene;
  const models::RealismModel& realism;
  const PushModel model = prepare_push_model(scene.responses, &realism);
  const Eigen::Vector3f asked{0.4F, -0.5F, 0};
  std::array<float, models::kConfigurationComponents> character{};
  std::array<PushCandidate, 8> best{};
  std::size_t count = 0;
};

TEST(SearchPush, RanksEveryResponseByItsBestWidth) {
  const models::RealismModel realism = tests::random_realism(5, 300);
  const HeadSearch search(realism);
  const auto& [scene, of, model, asked, character, best, count] = search;
  ASSERT_EQ(count, scene.responses.responses.size());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_LE(best[i].realism, best[i == 0 ? 0 : i - 1].realism);
    float most = 0;
    PushCandidate each = best[i];
    for (const float taper : kTapers) {
      each.taper = taper;
      most = std::max(
          most,
          models::estimate_realism(
              realism,
              realism_features(character, model.components[static_cast<std::size_t>(each.response)],
                               each, asked)));
    }
    EXPECT_NEAR(best[i].realism, most, 1e-4F);
  }
}

TEST(SearchPush, OfThePapersFEveryResponseHasTheThetaOfItsNearestExamples) {
  std::mt19937 random(4);
  models::RealismModel realism = tests::random_realism(5, 300);
  realism.theta = random_theta(random, 300);
  const HeadSearch search(realism);
  const auto& [scene, of, model, asked, character, best, count] = search;
  ASSERT_EQ(count, scene.responses.responses.size());
  for (std::size_t i = 0; i < count; ++i) {
    const PushCandidate& found = best[i];
    EXPECT_LE(found.realism, best[i == 0 ? 0 : i - 1].realism);
    EXPECT_EQ(found.turn, 0);
    const auto response = static_cast<std::size_t>(found.response);
    models::ImpulseFeatures features;
    features.response = model.components[response];
    for (int k = 0; k < 3; ++k) {
      features.place[static_cast<std::size_t>(k)] =
          scene.responses.responses[response].configuration(
              3 * static_cast<Eigen::Index>(motion::Role::head) + k);
      features.velocity[static_cast<std::size_t>(k)] = asked(k);
    }
    const auto theta = theta_by_sorting(*realism.theta, features);
    EXPECT_NEAR(double{std::log(found.taper)}, theta[0], 1e-4);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(double{found.deformation(k)}, theta[static_cast<std::size_t>(k) + 1], 1e-4);
    EXPECT_NEAR(found.realism,
                models::estimate_realism(
                    realism, realism_features(character, model.components[response], found, asked)),
                1e-4F);
  }
}

TEST(DeformedCandidate, TurnsByAtMostThirtyDegreesAndDeformsTheRest) {
  const tests::PushScene scene;
  const Eigen::Vector3f recorded = scene.responses.responses[0].velocity[0];
  const Eigen::Vector3f own(recorded.x(), recorded.y(), 0);
  const auto turned = [&](float degrees) {
    return Eigen::Vector3f(
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::radians(degrees)) * own);
  };
  const auto candidate = [&](float degrees, SearchOptions options) {
    return deformed_candidate(scene.responses, 0, motion::Role::chest, turned(degrees), options);
  };
  EXPECT_NEAR(candidate(20, {}).turn, motion::radians(20.0F), 1e-4F);
  EXPECT_LT(candidate(20, {}).deformation.norm(), 1e-4F);
  EXPECT_EQ(candidate(-50, {}).turn, -kMaxResponseTurn);
  EXPECT_LT((candidate(-50, {}).deformation - (turned(-50) - turned(-30))).norm(), 1e-4F);
  EXPECT_EQ(candidate(20, {.deforms = true, .turns = false}).turn, 0);
  EXPECT_EQ(candidate(20, {.deforms = false, .turns = false}).deformation.norm(), 0);
}

}  // namespace
}  // namespace flinch::runtime
