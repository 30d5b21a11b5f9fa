// SPDX-License-Identifier: MIT
#include "train/fit/response_costs.h"

#include <gtest/gtest.h>

namespace flinch::train {
namespace {

/// An observation of clip 1 (and idle) at a time to impact.
Observation observed(float time_s, float work_j) {
  Observation observation;
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
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0, 0.5F), 100);
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0, 0.25F), 150) << "the mean of what was measured";
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0, 0.3F), 150) << "the nearest time";
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0, 0.45F), 100) << "the nearest time";
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0.5F, 0.5F), 100) << "another phase";
  EXPECT_FLOAT_EQ(work_j(costs, 2, 0, 0.4F), 90) << "never tried: its reference response";
  EXPECT_EQ(work_j(costs, 0, 0, 0.4F), 0);
}

TEST(ResponseCosts, NoObservationsGiveTheReferenceResponses) {
  const models::ResponseCosts costs = response_costs(three_clips(), {}, {});
  EXPECT_FLOAT_EQ(work_j(costs, 1, 0, 0.4F), 70);
  EXPECT_FLOAT_EQ(work_j(costs, 2, 0, 0.4F), 90);
}

}  // namespace
}  // namespace flinch::train
