// SPDX-License-Identifier: MIT
#include "evolve/trial/threat_grid.h"

#include <gtest/gtest.h>

#include "motion/rotation.h"

namespace flinch::evolve {
namespace {

features::Random random_of(std::uint64_t draw) {
  return {1, features::RandomStream::threat_grid, draw};
}

TEST(ThreatGrid, BallsStartAtOnePointAndPassTheirCellsAtTheTimeOfTheImpact) {
  AimedThrow thrown;
  thrown.aim = {0.1, 0.2, 1.6};
  for (const double degrees : {0.0, 30.0, -60.0, 180.0}) {
    thrown.azimuth = motion::radians(degrees);
    features::Random random = random_of(3);
    const auto balls = thrown_balls(thrown, {0.06, 0}, random);
    // Seen by the thrower: columns go to the right, rows go down.
    const Eigen::Vector3d from(std::cos(thrown.azimuth), std::sin(thrown.azimuth), 0);
    const Eigen::Vector3d right = (-from).cross(Eigen::Vector3d::UnitZ());
    for (std::size_t cell = 0; cell < kGridCells; ++cell) {
      EXPECT_LT((balls[cell].position - (thrown.aim + 12.5 * from)).norm(), 1e-12);
      EXPECT_NEAR(balls[cell].velocity.norm(), 25, 1e-12);
      EXPECT_EQ(balls[cell].gravity_mps2, 0);
      const Eigen::Vector3d passed = balls[cell].position_at(0.5) - thrown.aim;
      EXPECT_NEAR(passed.dot(right), 0.06 * (static_cast<double>(cell % 3) - 1), 1e-5);
      EXPECT_NEAR(passed.z(), -0.06 * (static_cast<double>(cell / 3) - 1), 1e-5);
      EXPECT_NEAR(passed.dot(from), 0, 5e-4);  // as long a way, turned
    }
  }
}

TEST(ThreatGrid, JitterMovesEveryBallByItsOwnAmountWithinItsBounds) {
  AimedThrow thrown;
  features::Random none = random_of(3);
  const auto middle = thrown_balls(thrown, {0.06, 0}, none);
  double most = 0;
  for (std::uint64_t draw = 0; draw < 50; ++draw) {
    features::Random random = random_of(draw);
    const auto balls = thrown_balls(thrown, {0.06, 0.01}, random);
    for (std::size_t cell = 0; cell < kGridCells; ++cell) {
      const Eigen::Vector3d off = balls[cell].position_at(0.5) - middle[cell].position_at(0.5);
      EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.0101);
      most = std::max(most, off.cwiseAbs().maxCoeff());
      if (cell > 0) {
        EXPECT_NE(balls[cell].velocity - middle[cell].velocity,
                  balls[0].velocity - middle[0].velocity);
      }
    }
  }
  EXPECT_GT(most, 0.009);
}

TEST(ThreatGrid, BallsFromAboveComeFromAbove) {
  AimedThrow thrown;
  thrown.elevation = motion::radians(30.0);
  features::Random random = random_of(1);
  const auto balls = thrown_balls(thrown, {0.06, 0}, random);
  EXPECT_NEAR(balls[4].velocity.z(), -12.5, 1e-9);
  EXPECT_NEAR(balls[4].position.z(), 6.25, 1e-9);
  EXPECT_GT(balls[1].position_at(0.5).z(), balls[7].position_at(0.5).z());
}

}  // namespace
}  // namespace flinch::evolve
