// SPDX-License-Identifier: MIT
#include "database/annotate/rest.h"

#include <gtest/gtest.h>

#include "database/annotate/movement.h"
#include "tests/database/annotate/take_scene.h"

namespace flinch::database {
namespace {

using tests::standing;

TEST(ConfidenceTest, IsAHalfAtTheLimitAndGrowsWithTheValue) {
  EXPECT_FLOAT_EQ(confidence_above(2, 2), 0.5F);
  EXPECT_FLOAT_EQ(confidence_above(4, 2), 0.8F);
  EXPECT_FLOAT_EQ(confidence_above(1, 2), 0.2F);
  EXPECT_FLOAT_EQ(confidence_above(-1, 2), 0);
}

TEST(RestTest, TPoseIsNotTheIdle) {
  // 3 s in a T-pose, arms down within a second, 2 s of rest.
  const Take take = tests::take_of(6, [](double time_s) {
    motion::Pose pose = standing();
    const float raised = 1 - tests::minimum_jerk(time_s, 3, 4);
    for (motion::Side side : {motion::Side::left, motion::Side::right}) {
      motion::set_arm(pose, side, {.abduction = raised * 1.5708F});
    }
    return pose;
  });
  const TakeSignals signals = signals_of(take.figure, take.motion);
  EXPECT_TRUE(is_t_pose(signals.world.joints.front()));
  EXPECT_FALSE(is_t_pose(signals.world.joints.back()));
  const auto idle = find_idle(signals.world, signals.speed_mps, signals.departure_m, signals.still);
  ASSERT_TRUE(idle);
  EXPECT_GE(idle->value.first, 200U);
  EXPECT_TRUE(find_movements(signals).empty());  // arms that come down from it are no clip
}

TEST(RunningMedianTest, IsTheMedianOfTheNeighbours) {
  const std::vector<float> values{5, 1, 4, 2, 3, 9, 7};
  const std::vector<float> median = running_median(values, 1, 1);
  EXPECT_EQ(median, (std::vector<float>{1, 4, 2, 3, 3, 7, 7}));
}

}  // namespace
}  // namespace flinch::database
