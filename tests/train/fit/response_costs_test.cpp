// SPDX-License-Identifier: MIT
#include "train/fit/response_costs.h"

#include <gtest/gtest.h>

namespace flinch::train {
namespace {

/// An observation of clip 1 (and idle) at a time to impact.
Observation observed(float time_s, float work_j, int stance = 0) {
  Observation observation;
  observation.scenario.state.stance = stance;
  observation.scenario.time_to_impact_s = time_s;
  observation.trials = {{.clip = 0, .work_j = 0, .impulse = {}},
                        {.clip = 1, .work_j = work_j, .impulse = {}}};
  return observation;
}

StoreHeader three_clips() {
  StoreHeader header;
  header.clips.resize(3);
  header.clip_work_j = {0, 70, 90};
  return header;
}

TEST(ResponseCosts, HoldTheConstantsOfTheCostModel) {
  CostModel model;
  model.reference_damage_ns = {13, 17};
  model.reference_work_j = 400;
  const models::ResponseCosts costs = response_costs(three_clips(), {}, model);
  EXPECT_EQ(costs.vulnerability, model.vulnerability);
  EXPECT_EQ(costs.reference_damage_ns, (std::vector<double>{13, 17}));
  EXPECT_EQ(costs.reference_work_j, 400);
}

// A selector of the default table has no name of a table in its file, which so has the same bytes
// as those that earlier versions wrote.
TEST(ResponseCosts, NameEveryVulnerabilityTableButTheDefault) {
  CostModel model;
  EXPECT_EQ(response_costs(three_clips(), {}, model).vulnerability_name, "");
  model.vulnerability_name = "armour";
  EXPECT_EQ(response_costs(three_clips(), {}, model).vulnerability_name, "armour");
}

TEST(ResponseCosts, WorkIsThatOfTheObservationsElseOfTheNearestTimeElseOfTheReference) {
  const std::vector<Observation> observations{observed(0.5F, 100), observed(0.25F, 160),
                                              observed(0.25F, 140)};
  const models::ResponseCosts costs = response_costs(three_clips(), observations, {});
  ASSERT_EQ(costs.time_count, 6);
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.5F}), 100);
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.25F}), 150) << "the mean of what was measured";
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.3F}), 150) << "the nearest time";
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.45F}), 100) << "the nearest time";
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0.5F, 0.5F}), 100) << "another phase";
  EXPECT_FLOAT_EQ(work_j(costs, 2, {0, 0, 0.4F}), 90) << "never tried: its reference response";
  EXPECT_EQ(work_j(costs, 0, {0, 0, 0.4F}), 0);
}

TEST(ResponseCosts, WorkFromAStanceIsThatOfTheObservationsWhichBeginThere) {
  StoreHeader header = three_clips();
  header.stances = {"idle", "walk", "guard"};
  const std::vector<Observation> observations{observed(0.5F, 100), observed(0.5F, 300, 2),
                                              observed(0.25F, 210, 2), observed(0.25F, 230, 2)};
  const models::ResponseCosts costs = response_costs(header, observations, {});
  ASSERT_EQ(costs.of_stance.size(), 1U) << "no scenario begins in the walk";
  EXPECT_EQ(costs.of_stance[0].stance, 2);
  EXPECT_EQ(costs.of_stance[0].phase_count, 8);
  EXPECT_FLOAT_EQ(work_j(costs, 1, {2, 0, 0.5F}), 300);
  EXPECT_FLOAT_EQ(work_j(costs, 1, {2, 0, 0.25F}), 220) << "the mean of what was measured";
  EXPECT_FLOAT_EQ(work_j(costs, 1, {2, 0.5F, 0.3F}), 220) << "the nearest time";
  // Clip 1 takes (300 + 210 + 230) / 3 J from there, its reference response 70.
  EXPECT_FLOAT_EQ(work_j(costs, 2, {2, 0, 0.4F}), 90 + 740.0F / 3 - 70) << "never tried";
  EXPECT_EQ(work_j(costs, 0, {2, 0, 0.4F}), 0);
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.25F}), 100) << "idle has what begins in idle";
  EXPECT_FLOAT_EQ(work_j(costs, 2, {0, 0, 0.25F}), 90);
}

TEST(ResponseCosts, NoObservationsGiveTheReferenceResponses) {
  const models::ResponseCosts costs = response_costs(three_clips(), {}, {});
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.4F}), 70);
  EXPECT_FLOAT_EQ(work_j(costs, 2, {0, 0, 0.4F}), 90);
}

}  // namespace
}  // namespace flinch::train
