// SPDX-License-Identifier: MIT
#include "features/feature_vector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "motion/default_character.h"
#include "motion/error.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/error_of.h"

namespace flinch::features {
namespace {

const std::vector<std::string> kNames(kFeatureNames.begin(), kFeatureNames.end());

// An idle motion that moves 0.1 m to the left and turns the pelvis by 0.2 rad to the left in 1 s.
motion::Motion swaying_idle() {
  motion::Motion idle;
  const motion::Pose rest = motion::rest_pose(motion::default_character().skeleton);
  for (int i = 0; i <= 60; ++i) {
    const float share = static_cast<float>(i) / 60;
    motion::Pose pose = rest;
    pose.root_position.y() = 0.1F * share;
    pose.rotation[motion::Role::pelvis] = Eigen::AngleAxisf(0.2F * share, Eigen::Vector3f::UnitZ());
    idle.poses.push_back(pose);
  }
  return idle;
}

// A character at (1, 2) that faces +Y, and a ball 3 m ahead, 1 m to the left (-X) and 1.5 m up that
// flies towards it.
TEST(Features, MatchAHandComputedScenario) {
  Scenario scenario;
  scenario.state = {.idle_time_s = 0, .position = {1, 2}, .facing = std::acos(-1.0F) / 2};
  scenario.threat.position = {0, 5, 1.5F};
  scenario.threat.velocity = {0, -12, 5};
  scenario.target = motion::Target::pelvis;
  scenario.time_to_impact_s = 0.5F;
  const Features features = features_of(scenario, swaying_idle());
  EXPECT_NEAR(features.position_x, 3, 1e-5F);
  EXPECT_NEAR(features.position_y, 1, 1e-5F);
  EXPECT_NEAR(features.position_z, 1.5F, 1e-5F);
  EXPECT_NEAR(features.heading_x, -12.0F / 13, 1e-5F);
  EXPECT_NEAR(features.heading_y, 0, 1e-5F);
  EXPECT_NEAR(features.heading_z, 5.0F / 13, 1e-5F);
  EXPECT_NEAR(features.speed_mps, 13, 1e-5F);
  EXPECT_EQ(features.time_to_impact_s, 0.5F);
  EXPECT_EQ(features.target_pelvis, 1);
  EXPECT_EQ(features.target_head + features.target_trunk + features.target_legs, 0);
  EXPECT_NEAR(features.ahead_x, 0, 1e-5F);
  EXPECT_NEAR(features.ahead_y, 0.05F, 1e-5F);
  EXPECT_NEAR(features.ahead_facing_sin, std::sin(0.1F), 1e-5F);
  EXPECT_NEAR(features.ahead_facing_cos, std::cos(0.1F), 1e-5F);
}

TEST(Features, AreInvariantToRigidMotionOfTheWorld) {
  std::mt19937 random(1);
  const motion::Motion idle = swaying_idle();
  for (int i = 0; i < 200; ++i) {
    Scenario scenario;
    scenario.state = {.idle_time_s = tests::uniform(random, 0, 5),
                      .position = tests::random_vector(random, 3).head<2>(),
                      .facing = tests::uniform(random, -3, 3)};
    scenario.threat.position = tests::random_vector(random, 10);
    scenario.threat.velocity = tests::random_vector(random, 20);
    scenario.time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
    const float yaw = tests::uniform(random, -3, 3);
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    Eigen::Vector3f move = tests::random_vector(random, 5);
    move.z() = 0;

    Scenario moved = scenario;
    const Eigen::Vector3f stand(scenario.state.position.x(), scenario.state.position.y(), 0);
    moved.state.position = (turn * stand + move).head<2>();
    moved.state.facing += yaw;
    moved.threat.position = turn * scenario.threat.position + move;
    moved.threat.velocity = turn * scenario.threat.velocity;
    const FeatureVector before = to_vector(features_of(scenario, idle));
    const FeatureVector after = to_vector(features_of(moved, idle));
    EXPECT_THAT(after, testing::Pointwise(testing::FloatNear(2e-5F), before));
  }
}

TEST(Features, AreFiniteForAThreatAtRest) {
  const FeatureVector vector = to_vector(features_of(Scenario{}, swaying_idle()));
  for (float value : vector) EXPECT_TRUE(std::isfinite(value));
}

TEST(FeatureVector, ComponentsStandInTheOrderOfTheirNames) {
  Features features{};
  features.position_z = 3;
  features.speed_mps = 7;
  features.target_legs = 12;
  features.ahead_facing_cos = 16;
  const FeatureVector vector = to_vector(features);
  const auto at = [&](std::string_view name) {
    const auto found = std::find(kFeatureNames.begin(), kFeatureNames.end(), name);
    return vector[static_cast<std::size_t>(found - kFeatureNames.begin())];
  };
  EXPECT_EQ(at("position_z"), 3);
  EXPECT_EQ(at("speed_mps"), 7);
  EXPECT_EQ(at("target_legs"), 12);
  EXPECT_EQ(at("ahead_facing_cos"), 16);
  EXPECT_EQ(std::set(kFeatureNames.begin(), kFeatureNames.end()).size(), kFeatureNames.size());
}

TEST(Scaling, MapsTheRangeToMinusOneToOneAndConstantsToZero) {
  std::vector<FeatureVector> rows(3);
  for (FeatureVector& row : rows) row.fill(5);
  rows[0][2] = -4;
  rows[1][2] = 0;
  rows[2][2] = 12;
  const Scaling scaling = make_scaling(rows, kNames);
  std::array<double, kFeatureCount> scaled{};
  const auto scaled_third = [&](const FeatureVector& row) {
    scaling.apply(row, scaled);
    return scaled[2];
  };
  EXPECT_DOUBLE_EQ(scaled_third(rows[0]), -1);
  EXPECT_DOUBLE_EQ(scaled_third(rows[1]), -0.5);
  EXPECT_DOUBLE_EQ(scaled_third(rows[2]), 1);
  EXPECT_EQ(scaled[0], 0);
}

TEST(Scaling, RefusesNoRowsAndNumbersThatAreNotFinite) {
  EXPECT_THROW(make_scaling({}, kNames), Error);
  std::vector<FeatureVector> rows(2);
  for (FeatureVector& row : rows) row.fill(0);
  rows[1][6] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(tests::error_of([&] { make_scaling(rows, kNames); }),
              testing::HasSubstr("speed_mps of observation 1"));
}

}  // namespace
}  // namespace flinch::features
