// SPDX-License-Identifier: MIT
#include "features/geometry.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/motion/random_motion.h"

namespace flinch::features {
namespace {

constexpr float kTolerance = 1e-4F;

using Components = std::array<float, kGeometryCount>;

Components components_of(const Geometry& geometry) {
  return std::bit_cast<Components>(geometry);
}

PredictedCharacter upright() {
  PredictedCharacter character;
  character.pelvis = {0, 0, 1};
  for (int i = 0; i < motion::kTargetCount; ++i) {
    character.target_centres[static_cast<motion::Target>(i)] = {
        0, 0, 1.6F - 0.4F * static_cast<float>(i)};
  }
  return character;
}

/// A scenario whose threat passes `point` with `velocity` after one second.
Scenario passing(const Eigen::Vector3f& point, const Eigen::Vector3f& velocity) {
  Scenario scenario;
  scenario.time_to_impact_s = 1;
  scenario.threat.position = point;
  scenario.threat.velocity = velocity;
  scenario.threat = advanced(scenario.threat, -1);
  scenario.target = motion::Target::trunk;
  return scenario;
}

// The ball comes from the front, horizontally at 10 m/s, 0.2 m to the left of the character's axis,
// at a height of 1.3 m; the trunk's centre is at 1.2 m. It flies along -X, so its left is the
// character's right.
TEST(Geometry, MatchesAHandComputedPass) {
  const Geometry g = geometry_of(passing({0.5F, 0.2F, 1.3F}, {-10, 0, 0}), upright());
  // nearest to the axis, whatever the ball's position then
  EXPECT_NEAR(g.contact_x, 0, kTolerance);
  EXPECT_NEAR(g.contact_y, 0.2F, kTolerance);
  EXPECT_NEAR(g.contact_z, 1.3F, kTolerance);
  EXPECT_NEAR(g.approach_x, -1, kTolerance);
  EXPECT_NEAR(g.approach_y, 0, kTolerance);
  EXPECT_NEAR(g.approach_z, 0, kTolerance);
  EXPECT_NEAR(g.impact_speed_mps, 10, kTolerance);
  EXPECT_NEAR(g.offset_side, -0.2F, kTolerance);
  EXPECT_NEAR(g.offset_up, 0.1F, kTolerance);
  EXPECT_NEAR(g.miss_head_side, -0.2F, kTolerance);
  EXPECT_NEAR(g.miss_head_up, -0.3F, kTolerance);
  EXPECT_NEAR(g.miss_pelvis_up, 0.5F, kTolerance);
  EXPECT_NEAR(g.miss_legs_up, 0.9F, kTolerance);
}

TEST(Geometry, MissesArePerpendicularToThePathWithTheRightLength) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3f point = tests::random_vector(random, 1) + Eigen::Vector3f(0, 0, 1);
    const Eigen::Vector3f velocity = tests::random_vector(random, 20);
    const PredictedCharacter character = upright();
    const Geometry g = geometry_of(passing(point, velocity), character);
    // Brute force: the minimum distance over points of the line.
    const Eigen::Vector3f head = character.target_centres[motion::Target::head];
    float min_distance = 1e9F;
    for (int k = -4000; k <= 4000; ++k) {
      const float along = static_cast<float>(k) * 1e-3F;
      min_distance = std::min(min_distance, (point + along * velocity.normalized() - head).norm());
    }
    EXPECT_NEAR(std::hypot(g.miss_head_side, g.miss_head_up), min_distance, 2e-3F);
  }
}

TEST(Geometry, IsIndependentOfThePointAlongThePath) {
  const PredictedCharacter character = upright();
  Scenario early = passing({0.1F, -0.2F, 1.1F}, {-15, 8, 0});
  Scenario late = early;
  late.time_to_impact_s += 0.004F;
  const Components a = components_of(geometry_of(early, character));
  const Components b = components_of(geometry_of(late, character));
  // Gravity bends the path by g t v in 4 ms: a few millimetres in 7 cm of flight.
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 0.02F) << kGeometryNames[i];
}

TEST(Geometry, IsInvariantToRigidMotionOfTheWorld) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    Scenario scenario = passing(tests::random_vector(random, 1), tests::random_vector(random, 20));
    scenario.state.facing = tests::uniform(random, -3, 3);
    PredictedCharacter character = upright();
    for (Eigen::Vector3f& centre : character.target_centres)
      centre += tests::random_vector(random, 0.1F);
    const float yaw = tests::uniform(random, -3, 3);
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    Eigen::Vector3f move = tests::random_vector(random, 5);
    move.z() = 0;
    Scenario moved = scenario;
    moved.state.facing += yaw;
    moved.threat.position = turn * scenario.threat.position + move;
    moved.threat.velocity = turn * scenario.threat.velocity;
    PredictedCharacter there = character;
    there.pelvis = turn * character.pelvis + move;
    for (Eigen::Vector3f& centre : there.target_centres) centre = turn * centre + move;
    const Components before = components_of(geometry_of(scenario, character));
    const Components after = components_of(geometry_of(moved, there));
    for (std::size_t k = 0; k < before.size(); ++k)
      EXPECT_NEAR(after[k], before[k], kTolerance) << kGeometryNames[k];
  }
}

TEST(Geometry, IsFiniteForAThreatAtRestOrFromStraightAbove) {
  Scenario at_rest;
  at_rest.threat.velocity = {0, 0, kGravity * at_rest.time_to_impact_s};
  const Scenario from_above = passing({0, 0, 2}, {0, 0, -20});
  for (const Scenario& scenario : {at_rest, from_above})
    for (const float value : components_of(geometry_of(scenario, upright())))
      EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace flinch::features
