// SPDX-License-Identifier: MIT
#include "models/response_costs.h"

#include <gtest/gtest.h>

namespace flinch::models {
namespace {

using motion::Body;

/// Two clips, two phases, times 0.25, 0.30 and 0.35 s: clip 1 does 100 + 10 phase + time J.
ResponseCosts small_costs() {
  ResponseCosts costs;
  costs.phase_count = 2;
  costs.time_count = 3;
  costs.min_time_s = 0.25F;
  costs.time_step_s = 0.05F;
  costs.work_j = {0, 0, 0, 0, 0, 0, 100, 101, 102, 110, 111, 112};
  return costs;
}

TEST(ResponseCosts, WorkIsWhatWasMeasuredAndLinearBetween) {
  const ResponseCosts costs = small_costs();
  EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, 0.25F}), 100);
  EXPECT_NEAR(work_j(costs, 1, {0, 0, 0.325F}), 101.5F, 1e-4F);
  EXPECT_NEAR(work_j(costs, 1, {0, 0.5F, 0.3F}), 111, 1e-4F);
  EXPECT_NEAR(work_j(costs, 1, {0, 0.25F, 0.3F}), 106, 1e-4F);
  EXPECT_NEAR(work_j(costs, 1, {0, 0.75F, 0.3F}), 106, 1e-4F) << "the last phase meets the first";
  EXPECT_NEAR(work_j(costs, 1, {0, -2.75F, 0.3F}), 106, 1e-4F) << "whole periods do not matter";
  EXPECT_EQ(work_j(costs, 0, {0, 0.3F, 0.3F}), 0);
}

TEST(ResponseCosts, WorkIsConstantBeyondTheMeasuredTimes) {
  const ResponseCosts costs = small_costs();
  for (const float late_s : {0.35F, 0.5F, 100.0F})
    EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, late_s}), 102);
  for (const float early_s : {0.25F, 0.1F, 0.0F})
    EXPECT_FLOAT_EQ(work_j(costs, 1, {0, 0, early_s}), 100);
}

TEST(ResponseCosts, WorkIsThatOfTheStanceInPhasesOfItsOwn) {
  ResponseCosts costs = small_costs();
  // From stance 2, with three phases, clip 1 does 200 + 10 phase + time J.
  costs.of_stance.push_back(
      {2, {5, 5, 5, 5, 5, 5, 5, 5, 5, 200, 201, 202, 210, 211, 212, 220, 221, 222}, 3});
  EXPECT_NEAR(work_j(costs, 1, {2, 0, 0.3F}), 201, 1e-4F);
  EXPECT_NEAR(work_j(costs, 1, {2, 0.5F, 0.325F}), 216.5F, 1e-4F);
  EXPECT_NEAR(work_j(costs, 1, {2, 5.0F / 6, 0.25F}), 210, 1e-3F);
  EXPECT_FLOAT_EQ(work_j(costs, 0, {2, 0.4F, 0.3F}), 5);
  EXPECT_NEAR(work_j(costs, 1, {0, 0.5F, 0.3F}), 111, 1e-4F) << "that from idle is as it was";
}

TEST(ResponseCosts, WorkIsKnownFromIdleAndFromStancesWithWorkOfTheirOwn) {
  ResponseCosts costs = small_costs();
  costs.of_stance.push_back({2, std::vector<float>(6, 7.0F), 1});
  EXPECT_TRUE(knows_work_from(costs, 0));
  EXPECT_FALSE(knows_work_from(costs, 1));
  EXPECT_TRUE(knows_work_from(costs, 2));
  EXPECT_FALSE(knows_work_from(costs, 3));
}

TEST(ResponseCosts, CostIsThatOfTheTrainer) {
  ResponseCosts costs = small_costs();
  costs.vulnerability[Body::head] = 1;
  costs.vulnerability[Body::left_hand] = 0.2;
  costs.reference_damage_ns = {12, 24};
  costs.reference_work_j = 300;
  motion::PerBody<double> impulse;
  impulse[Body::head] = 3;
  impulse[Body::left_hand] = 5;
  impulse[Body::chest] = 7;
  const double damage = damage_ns(costs, 0, impulse);
  EXPECT_DOUBLE_EQ(damage, 4);
  EXPECT_DOUBLE_EQ(cost_ns(costs, 0.25, 0, damage, 50), 0.75 * 4 + 0.25 * 50 * 12 / 300);
  EXPECT_DOUBLE_EQ(cost_ns(costs, 0.25, 1, damage, 50), 0.75 * 4 + 0.25 * 50 * 24 / 300);
  // A kind that it does not know counts as the first.
  EXPECT_DOUBLE_EQ(cost_ns(costs, 0.25, 2, damage, 50), 0.75 * 4 + 0.25 * 50 * 12 / 300);
}

}  // namespace
}  // namespace flinch::models
