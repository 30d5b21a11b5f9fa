// SPDX-License-Identifier: MIT
#include "motion/loop.h"

#include <gtest/gtest.h>

#include "motion/rotation.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

/// A quarter of a second in which a pose bends one arm and back, while it goes along an arc.
Motion arc(float yaw, const Eigen::Vector3f& way) {
  Motion motion;
  motion.rate_hz = 60;
  for (int k = 0; k <= 15; ++k) {
    const float share = static_cast<float>(k) / 15;
    Pose pose;
    pose.root_position = {0, 0, 1};
    pose.rotation[Role::left_forearm] =
        rotation_about(Eigen::Vector3f::UnitZ(), -std::sin(std::numbers::pi_v<float> * share));
    motion.poses.push_back(placed(pose, share * yaw, share * way));
  }
  return motion;
}

TEST(Loop, ContinuesWhereEachCycleEnds) {
  for (const float yaw : {0.0F, 0.3F, -1.2F}) {
    const Motion motion = arc(yaw, {0.5F, 0.1F, 0});
    const Loop loop = Loop::in_cycles(motion);
    Pose cycle_begins = motion.poses.front();
    for (int cycle = 0; cycle < 6; ++cycle) {
      const float begin_s = static_cast<float>(cycle) * loop.period_s();
      EXPECT_LT(tests::distance(sample(loop, begin_s + 1e-5F), cycle_begins), 1e-3F) << cycle;
      cycle_begins = placed(cycle_begins, loop.travel().yaw, loop.travel().translation);
      EXPECT_LT(tests::distance(sample(loop, begin_s + loop.period_s() - 1e-5F), cycle_begins),
                1e-3F)
          << cycle;
    }
  }
}

TEST(Loop, ManyMovesAreOneAfterTheOther) {
  for (const float yaw : {0.0F, 1e-6F, 0.4F, -2.5F}) {
    const PlanarMove move{yaw, {0.3F, -0.2F, 0}};
    Pose forth;
    Pose back;
    for (int times = 0; times < 9; ++times) {
      const PlanarMove many = repeated(move, times);
      EXPECT_LT(tests::distance(placed(Pose(), many.yaw, many.translation), forth), 1e-4F);
      const PlanarMove undone = repeated(move, -times);
      EXPECT_LT(tests::distance(placed(forth, undone.yaw, undone.translation), Pose()), 1e-4F);
      place(move.yaw, move.translation, forth);
    }
  }
}

TEST(Loop, PlaysBackAndForthUnlessToldOtherwise) {
  const Motion motion = arc(0, {0.5F, 0, 0});
  const Loop loop(motion);
  EXPECT_FALSE(loop.travels());
  EXPECT_EQ(loop.period_s(), 2 * motion.duration_s());
  for (float time_s = 0; time_s < 2; time_s += 0.013F)
    EXPECT_EQ(tests::distance(sample(loop, time_s), sample_ping_pong(motion, time_s)), 0);
}

TEST(Loop, TellsByHowMuchAMotionDoesNotLoop) {
  Motion motion = arc(0.2F, {0.5F, 0, 0});
  EXPECT_LT(loop_gap(motion).angle, 1e-3F);
  EXPECT_LT(loop_gap(motion).height_m, 1e-6F);
  motion.poses.back().root_position.z() += 0.03F;
  motion.poses.back().rotation[Role::left_shin] = rotation_about(Eigen::Vector3f::UnitY(), 0.25F);
  const LoopGap gap = loop_gap(motion);
  EXPECT_NEAR(gap.height_m, 0.03F, 1e-5F);
  EXPECT_NEAR(gap.angle, 0.25F, 1e-3F);
  EXPECT_EQ(gap.joint, Role::left_shin);
}

}  // namespace
}  // namespace flinch::motion
