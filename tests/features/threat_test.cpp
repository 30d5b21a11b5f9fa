// SPDX-License-Identifier: MIT
#include "features/threat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/motion/random_motion.h"
#include "tests/scenes/not_finite.h"

namespace flinch::features {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// A ball thrown straight up at 9.81 m/s is at rest 4.905 m higher after 1 s, and back after 2 s.
TEST(Threat, FollowsAParabola) {
  Threat ball;
  ball.position = {1, 2, 3};
  ball.velocity = {4, 0, 9.81F};
  EXPECT_LT((position_at(ball, 1) - Eigen::Vector3f(5, 2, 7.905F)).norm(), 1e-5F);
  EXPECT_LT((velocity_at(ball, 1) - Eigen::Vector3f(4, 0, 0)).norm(), 1e-5F);
  EXPECT_LT((position_at(ball, 2) - Eigen::Vector3f(9, 2, 3)).norm(), 1e-5F);
  EXPECT_EQ(position_at(ball, 0), ball.position);
}

TEST(Threat, AdvancedStaysOnTheSamePath) {
  Threat ball;
  ball.position = {1, 2, 3};
  ball.velocity = {4, -1, 5};
  ball.radius = 0.2F;
  const Threat later = advanced(ball, 0.3F);
  EXPECT_LT((position_at(later, 0.4F) - position_at(ball, 0.7F)).norm(), 1e-5F);
  EXPECT_LT((velocity_at(later, 0.4F) - velocity_at(ball, 0.7F)).norm(), 1e-5F);
  EXPECT_EQ(later.radius, ball.radius);
}

TEST(Threat, IsUsableWithinItsRanges) {
  Threat good;
  good.position = {1e6F, -1e6F, 0};
  good.velocity = {0, -0.0F, -1e6F};
  good.radius = 0;
  good.mass_kg = 0;
  EXPECT_TRUE(is_usable(good));
  for (float bad : {tests::kNan, tests::kInfinity, -tests::kInfinity, 1.1e6F, -1.1e6F}) {
    for (int i = 0; i < 8; ++i) {
      Threat threat = good;
      (i < 3   ? threat.position[i]
       : i < 6 ? threat.velocity[i - 3]
       : i < 7 ? threat.radius
               : threat.mass_kg) = bad;
      EXPECT_FALSE(is_usable(threat)) << "number " << i << " is " << bad;
    }
  }
  Threat negative;
  negative.mass_kg = -1e-3F;
  EXPECT_FALSE(is_usable(negative));
  negative = {};
  negative.radius = -1e-3F;
  EXPECT_FALSE(is_usable(negative));
}

// The trajectory agrees with step-by-step integration of Newton's second law.
TEST(Threat, MatchesNumericalIntegration) {
  Threat ball;
  ball.position = {3, -1, 1};
  ball.velocity = {-8, 2, 3};
  Eigen::Vector3d position = ball.position.cast<double>();
  Eigen::Vector3d velocity = ball.velocity.cast<double>();
  const double step_s = 1e-4;
  for (int i = 0; i < 10000; ++i) {
    position += step_s * velocity + 0.5 * step_s * step_s * Eigen::Vector3d(0, 0, -9.81);
    velocity.z() -= step_s * 9.81;
  }
  EXPECT_LT((position_at(ball, 1).cast<double>() - position).norm(), 1e-4);
  EXPECT_LT((velocity_at(ball, 1).cast<double>() - velocity).norm(), 1e-4);
}

TEST(ThreatFromDescription, ReachesTheImpactPointOnTimeAtTheGivenSpeed) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const ThreatDescription approach{.azimuth = tests::uniform(random, -kPi, kPi),
                                     .elevation = tests::uniform(random, -0.2F, 0.8F),
                                     .speed_mps = tests::uniform(random, 8, 30),
                                     .time_to_impact_s = tests::uniform(random, 0.25F, 1.2F),
                                     .radius = 0.2F,
                                     .mass_kg = 0.5F};
    const Eigen::Vector3f point = tests::random_vector(random, 2);
    const Threat threat =
        threat_from_description(approach, point, tests::uniform(random, -kPi, kPi));
    EXPECT_LT((position_at(threat, approach.time_to_impact_s) - point).norm(), 1e-4F);
    const Eigen::Vector3f velocity = velocity_at(threat, approach.time_to_impact_s);
    EXPECT_NEAR(velocity.norm(), approach.speed_mps, 1e-4F);
    EXPECT_NEAR(-velocity.z() / velocity.norm(), std::sin(approach.elevation), 1e-5F);
    EXPECT_EQ(threat.radius, 0.2F);
    EXPECT_EQ(threat.mass_kg, 0.5F);
  }
}

// The left of a character that faces +Y is -X. A horizontal ball from there flies towards +X; a
// ball from 30 degrees above descends with half its speed.
TEST(ThreatFromDescription, AzimuthAndElevationGiveItsOrigin) {
  ThreatDescription approach{
      .azimuth = kPi / 2, .elevation = 0, .speed_mps = 20, .time_to_impact_s = 0.5F};
  const auto at_impact = [&] {
    return velocity_at(threat_from_description(approach, {0, 0, 1}, kPi / 2), 0.5F);
  };
  EXPECT_LT((at_impact() - Eigen::Vector3f(20, 0, 0)).norm(), 1e-4F);
  approach.azimuth = 0;
  EXPECT_LT((at_impact() - Eigen::Vector3f(0, -20, 0)).norm(), 1e-4F);
  approach.elevation = kPi / 6;
  EXPECT_NEAR(at_impact().z(), -10, 1e-4F);
}

}  // namespace
}  // namespace flinch::features
