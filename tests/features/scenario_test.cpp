// SPDX-License-Identifier: MIT
#include "features/scenario.h"

#include <gtest/gtest.h>

#include "motion/interpolation.h"
#include "motion/loop.h"
#include "tests/motion/random_motion.h"

namespace flinch::features {
namespace {

using motion::Target;

TEST(IsAllowed, AllowsAnnotatedClipsOfTheTargetAndItsNeighbours) {
  const auto allowed = [](Target threatened, Target protects) {
    return is_allowed(threatened, motion::Annotation{.target = protects});
  };
  constexpr auto& kTargets = motion::kTargets;
  constexpr std::array<std::array<bool, 4>, 4> kExpected{{{true, true, false, false},
                                                          {true, true, true, false},
                                                          {false, true, true, true},
                                                          {false, false, true, true}}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      EXPECT_EQ(allowed(kTargets[i], kTargets[j]), kExpected[i][j]);
    EXPECT_FALSE(is_allowed(kTargets[i], std::nullopt));
  }
}

TEST(IdlePose, IsTheIdleClipInTheCharactersFrame) {
  std::mt19937 random(1);
  const motion::Pose from = tests::random_pose(random, 0.3F);
  const motion::Pose to = tests::random_pose(random, 0.3F);
  motion::Motion idle;
  for (int i = 0; i <= 60; ++i)
    idle.poses.push_back(motion::blend(from, to, static_cast<float>(i) / 60));
  const CharacterState state{.idle_time_s = 0.25F, .position = {3, 4}, .facing = 1.1F};
  for (float time_s : {0.0F, 0.5F, 1.5F, 17.0F}) {
    const motion::Pose pose = idle_pose(idle, state, time_s);
    const motion::Pose expected =
        motion::placed(motion::sample_ping_pong(idle, 0.25F + time_s), 1.1F, {3, 4, 0});
    EXPECT_LT(tests::distance(pose, expected), 1e-6F);
  }
  // The clip turns round at 1 s, so the poses half a second before and after are equal.
  EXPECT_LT(tests::distance(idle_pose(idle, state, 0.25F), idle_pose(idle, state, 1.25F)), 1e-4F);
}

}  // namespace
}  // namespace flinch::features
