// SPDX-License-Identifier: MIT
#include "reaction/recovery.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flinch::reaction {
namespace {

TEST(RecoverySchedule, MatchesTheTimesOfThePaper) {
  for (double simulation_only_s : {0.05, 0.075, 0.1}) {
    const RecoverySchedule schedule{.simulation_only_s = simulation_only_s};
    const double part_one_end_s = simulation_only_s + 0.260;
    const double part_two_end_s = part_one_end_s + 0.375;
    EXPECT_DOUBLE_EQ(simulation_end_s(schedule), part_one_end_s);
    EXPECT_DOUBLE_EQ(duration_s(schedule), part_two_end_s);
    for (double time_s : {-1.0, 0.0, simulation_only_s}) {
      EXPECT_EQ(weights_at(schedule, time_s).simulated, 1);
      EXPECT_EQ(weights_at(schedule, time_s).returning, 0);
    }
    EXPECT_NEAR(weights_at(schedule, simulation_only_s + 0.13).simulated, 0.5, 1e-12);
    EXPECT_NEAR(weights_at(schedule, part_one_end_s).simulated, 0, 1e-12);
    EXPECT_NEAR(weights_at(schedule, part_one_end_s).returning, 0.25, 1e-12);
    EXPECT_LT(weights_at(schedule, part_two_end_s - 0.01).returning, 1);
    EXPECT_NEAR(weights_at(schedule, part_two_end_s).returning, 1, 1e-12);
    EXPECT_EQ(weights_at(schedule, 100).returning, 1);
  }
}

TEST(RecoverySchedule, WeightsAreMonotonicAndSmooth) {
  constexpr double kStep_s = 1e-4;
  const RecoverySchedule schedule;
  RecoveryWeights last = weights_at(schedule, 0);
  RecoveryWeights rate{0, 0};
  int moving = 0;
  for (int k = 1; k <= 9000; ++k) {
    const RecoveryWeights now = weights_at(schedule, k * kStep_s);
    const RecoveryWeights next{(now.simulated - last.simulated) / kStep_s,
                               (now.returning - last.returning) / kStep_s};
    EXPECT_LE(next.simulated, 1e-9);
    EXPECT_GE(next.returning, -1e-9);
    // The second derivative of an ease over T is at most 6 / T^2.
    EXPECT_LE(std::abs(next.simulated - rate.simulated), 1.01 * 6 / (0.26 * 0.26) * kStep_s);
    EXPECT_LE(std::abs(next.returning - rate.returning), 1.01 * 6 / (0.55 * 0.55) * kStep_s);
    if (next.returning > 0) ++moving;
    last = now;
    rate = next;
  }
  EXPECT_NEAR(moving * kStep_s, 0.375 / 0.67365, 1e-3);
}

}  // namespace
}  // namespace flinch::reaction
