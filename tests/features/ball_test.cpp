// SPDX-License-Identifier: MIT
#include "features/ball.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flinch::features {
namespace {

TEST(TimeOfBounce, MatchesTheTimeOfFall) {
  Ball ball;
  ball.position = {0, 0, 1.1};
  ball.radius = 0.1;
  ball.gravity_mps2 = 10;
  // A free fall of 1 m takes sqrt(2 / 10) s.
  const auto fallen = time_of_bounce(ball, 1, 0);
  ASSERT_TRUE(fallen);
  EXPECT_NEAR(*fallen, std::sqrt(0.2), 1e-12);
  EXPECT_FALSE(time_of_bounce(ball, 0.4, 0));

  ball.position.z() = 0.1;
  ball.velocity.z() = 5;
  const auto thrown = time_of_bounce(ball, 2, 0);
  ASSERT_TRUE(thrown);
  EXPECT_NEAR(*thrown, 1, 1e-12);
}

}  // namespace
}  // namespace flinch::features
