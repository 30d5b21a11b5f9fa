// SPDX-License-Identifier: MIT
#include "train/objective/cost.h"

#include <gtest/gtest.h>

namespace flinch::train {
namespace {

using motion::Body;

TEST(Vulnerability, DefaultRanksBodiesByInjuryWithARatioOfThreeToSeven) {
  const Vulnerability& v = vulnerability_profiles()[0].vulnerability;
  for (const bool left : {true, false}) {
    const double hand = v[left ? Body::left_hand : Body::right_hand];
    const double forearm = v[left ? Body::left_forearm : Body::right_forearm];
    const double upper_arm = v[left ? Body::left_upper_arm : Body::right_upper_arm];
    EXPECT_LT(hand, forearm);
    EXPECT_LT(forearm, upper_arm);
    for (const Body leg : left
                              ? std::array{Body::left_thigh, Body::left_shin, Body::left_foot}
                              : std::array{Body::right_thigh, Body::right_shin, Body::right_foot}) {
      EXPECT_LT(upper_arm, v[leg]);
      for (const Body trunk : {Body::pelvis, Body::abdomen, Body::chest}) {
        EXPECT_LT(v[leg], v[trunk]);
        EXPECT_LT(v[trunk], v[Body::neck]);
        EXPECT_LT(v[trunk], v[Body::head]);
      }
    }
    EXPECT_GE(v[Body::head] / hand, 3);
    EXPECT_LE(v[Body::head] / hand, 7);
  }
}

TEST(Vulnerability, ProfilesAreFoundByName) {
  EXPECT_EQ(vulnerability_profile_named("uniform")->vulnerability[Body::left_hand], 1);
  EXPECT_EQ(vulnerability_profile_named("nonsense"), nullptr);
}

TEST(Cost, MatchesItsFormula) {
  CostModel model;
  model.vulnerability = {};
  model.vulnerability[Body::head] = 2;
  model.vulnerability[Body::left_hand] = 0.5;
  model.brawn = 0.25;
  features::KnownKind light;
  light.mass_kg = light.speed_mps = {1, 2};
  light.bounce.restitution = 0.25;
  features::KnownKind heavy = light;
  heavy.mass_kg.max = 4;
  model.reference_damage_ns = {reference_damage_ns(model.vulnerability, light),
                               reference_damage_ns(model.vulnerability, heavy)};
  model.reference_work_j = 400;
  Trial trial;
  trial.work_j = 100;
  trial.impulse[Body::head] = 3;
  trial.impulse[Body::left_hand] = 4;
  trial.impulse[Body::pelvis] = 100;  // not vulnerable
  // damage = 2 * 3 + 0.5 * 4 = 8; D* = 2 * 1.25 * 2 * 2 = 10 and 20;
  // cost = 0.75 * 8 + 0.25 * 100 * D* / 400
  EXPECT_DOUBLE_EQ(damage_ns(trial.impulse, model.vulnerability), 8);
  EXPECT_DOUBLE_EQ(cost_of(trial, 0, model), 6.625);
  EXPECT_DOUBLE_EQ(cost_of(trial, 1, model), 7.25);
}

std::vector<Trial> trials(std::initializer_list<std::pair<int, float>> clip_and_work) {
  std::vector<Trial> made;
  for (const auto& [clip, work] : clip_and_work) {
    Trial trial;
    trial.clip = clip;
    trial.work_j = work;
    made.push_back(trial);
  }
  return made;
}

TEST(BestTrial, IsTheCheapest) {
  EXPECT_EQ(best_trial(trials({{0, 1}, {1, 9}, {2, 1}}), std::vector{3.0, 2.0, 2.5}), 1U);
}

TEST(BestTrial, AmongCostsWithinOnePercentHasTheLeastWork) {
  const auto three = trials({{0, 9}, {1, 5}, {2, 1}});
  EXPECT_EQ(best_trial(three, std::vector{1.0, 1.0099, 1.0101}), 1U);
  EXPECT_EQ(best_trial(three, std::vector{1.0, 1.0099, 1.0099}), 2U);
}

TEST(BestTrial, OfEqualCostAndWorkIsTheLowerClipIndex) {
  EXPECT_EQ(best_trial(trials({{4, 2}, {2, 2}, {3, 2}}), std::vector{1.0, 1.0, 1.0}), 1U);
}

TEST(BestTrial, ZeroCostTiesOnlyWithZero) {
  EXPECT_EQ(best_trial(trials({{0, 5}, {1, 0}}), std::vector{0.0, 1e-9}), 0U);
}

}  // namespace
}  // namespace flinch::train
