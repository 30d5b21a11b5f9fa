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

// Waits for 0.2 s, then moves 0.6 m in 0.1 s, whatever gravity does to other threats.
TEST(Threat, AStrokeWaitsMovesStraightAndStops) {
  Threat fist;
  fist.position = {1, 0, 1.5F};
  fist.velocity = {-6, 0, 0};
  fist.stroke = {0.2F, 0.1F};
  const auto x_at = [&](float time_s) { return position_at(fist, time_s).x(); };
  EXPECT_EQ(x_at(0), 1);
  EXPECT_EQ(x_at(0.2F), 1);
  EXPECT_NEAR(x_at(0.25F), 0.7F, 1e-6F);
  EXPECT_NEAR(x_at(0.3F), 0.4F, 1e-6F);
  EXPECT_EQ(x_at(5), x_at(0.3F));
  EXPECT_EQ(position_at(fist, 0.28F).z(), 1.5F);
  for (const float time_s : {0.0F, 0.25F, 5.0F})
    EXPECT_EQ(velocity_at(fist, time_s), fist.velocity);
  for (const float passed_s : {0.1F, 0.24F, 0.4F}) {
    for (const float time_s : {0.0F, 0.03F, 0.15F, 1.0F}) {
      EXPECT_LT(
          (position_at(advanced(fist, passed_s), time_s) - position_at(fist, passed_s + time_s))
              .norm(),
          1e-6F);
    }
  }
  for (const float bad : {-1e-3F, tests::kNan, tests::kInfinity}) {
    fist.stroke = {bad, 0.1F};
    EXPECT_FALSE(is_usable(fist));
    fist.stroke = {0.1F, bad};
    EXPECT_FALSE(is_usable(fist));
  }
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

TEST(ThreatFromDescription, AFistStartsAtItsReachFromTheImpactPointAndStopsThere) {
  const Eigen::Vector3f point(0, 0, 1.5F);
  ThreatDescription punch{.speed_mps = 8, .time_to_impact_s = 0.5F, .reach_m = 0.6F};
  Threat fist = threat_from_description(punch, point, 0);
  EXPECT_LT((fist.position - Eigen::Vector3f(0.6F, 0, 1.5F)).norm(), 1e-6F);
  EXPECT_NEAR(fist.stroke->starts_in_s, 0.5F - 0.6F / 8, 1e-6F);
  EXPECT_LT((position_at(fist, 0.5F) - point).norm(), 1e-6F);
  EXPECT_LT((position_at(fist, 2) - point).norm(), 1e-6F);
  // One that must have started before is under way.
  punch.time_to_impact_s = 0.05F;
  fist = threat_from_description(punch, point, 0);
  EXPECT_EQ(fist.stroke->starts_in_s, 0);
  EXPECT_NEAR(fist.position.x(), 0.4F, 1e-6F);
  EXPECT_LT((position_at(fist, 0.05F) - point).norm(), 1e-6F);
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
