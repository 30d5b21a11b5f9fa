// SPDX-License-Identifier: MIT
#include "motion/support_polygon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/body.h"
#include "motion/default_character.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

float area(const std::vector<Eigen::Vector2f>& polygon) {
  float twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f& a = polygon[i];
    const Eigen::Vector2f& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

std::vector<Eigen::Vector2f> standing(const Skeleton& skeleton) {
  return support_polygon(skeleton, forward_kinematics(skeleton, rest_pose(skeleton)));
}

// Both feet of a man: 0.266 m long, with 0.175 m between the ankles, so the outer edges at the
// balls are 0.175 + 0.19 * 2 * 0.266 = 0.276 m apart. The hull is smaller than that rectangle and
// larger than the part of it between the ankles' lines.
TEST(SupportPolygon, SpansBothFeet) {
  const std::vector<Eigen::Vector2f> polygon = standing(default_character().skeleton);
  const float length = 0.152F * 1.75F;
  EXPECT_GT(area(polygon), 0.175F * length);
  EXPECT_LT(area(polygon), (0.175F + 2 * 0.19F * length) * length);
  float least_x = 1;
  float most_x = -1;
  for (const Eigen::Vector2f& point : polygon) {
    least_x = std::min(least_x, point.x());
    most_x = std::max(most_x, point.x());
  }
  EXPECT_NEAR(most_x - least_x, length, 1e-4F);
  EXPECT_NEAR(least_x, -0.25F * length, 1e-4F);  // the heel
}

TEST(SupportPolygon, IsConvexCounterClockwiseAndMirrorSymmetric) {
  const std::vector<Eigen::Vector2f> polygon = standing(default_character().skeleton);
  ASSERT_GE(polygon.size(), 6U);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f a = polygon[i];
    const Eigen::Vector2f b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2f c = polygon[(i + 2) % polygon.size()];
    EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0);
    EXPECT_NEAR(signed_distance_inside(polygon, {a.x(), -a.y()}), 0, 1e-5F);
  }
}

TEST(SupportPolygon, ContainsTheStandingCentreOfMass) {
  const Physique man = default_character();
  const JointFrames rest = forward_kinematics(man.skeleton, rest_pose(man.skeleton));
  const Eigen::Vector3f centre = centre_of_mass(make_body_model(man), rest);
  const std::vector<Eigen::Vector2f> polygon = support_polygon(man.skeleton, rest);
  EXPECT_GT(signed_distance_inside(polygon, centre.head<2>()), 0.03F);
  EXPECT_LT(signed_distance_inside(polygon, {0.5F, 0}), 0);
}

TEST(SupportPolygon, ExcludesLiftedFeet) {
  const Skeleton skeleton = default_character().skeleton;
  Pose pose = rest_pose(skeleton);
  pose.rotation[Role::left_thigh] = Eigen::AngleAxisf(-1, Eigen::Vector3f::UnitY());
  for (const Eigen::Vector2f& point :
       support_polygon(skeleton, forward_kinematics(skeleton, pose))) {
    EXPECT_LT(point.y(), 0);  // the right foot alone
  }
  pose = rest_pose(skeleton);
  pose.root_position.z() += 0.1F;
  EXPECT_TRUE(support_polygon(skeleton, forward_kinematics(skeleton, pose)).empty());
}

TEST(SupportPolygon, IsUnderTheToesOnTiptoe) {
  const Skeleton skeleton = default_character().skeleton;
  Pose pose = rest_pose(skeleton);
  for (auto [foot, toes] :
       {std::pair{Role::left_foot, Role::left_toes}, {Role::right_foot, Role::right_toes}}) {
    pose.rotation[foot] = Eigen::AngleAxisf(0.6F, Eigen::Vector3f::UnitY());
    pose.rotation[toes] = Eigen::AngleAxisf(-0.6F, Eigen::Vector3f::UnitY());
  }
  const JointFrames lowered = forward_kinematics(skeleton, pose);
  pose.root_position.z() -= lowered.position[Role::left_toes].z() - 0.012F * 1.75F;
  const JointFrames frames = forward_kinematics(skeleton, pose);
  const std::vector<Eigen::Vector2f> polygon = support_polygon(skeleton, frames);
  ASSERT_GE(polygon.size(), 3U);
  EXPECT_LT(area(polygon), 0.5F * area(standing(skeleton)));
  for (const Eigen::Vector2f& point : polygon) EXPECT_GT(point.x(), 0.02F);
}

TEST(SignedDistance, MatchesTheUnitSquare) {
  const std::vector<Eigen::Vector2f> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_FLOAT_EQ(signed_distance_inside(square, {0.5F, 0.5F}), 0.5F);
  EXPECT_FLOAT_EQ(signed_distance_inside(square, {0.1F, 0.5F}), 0.1F);
  EXPECT_FLOAT_EQ(signed_distance_inside(square, {2, 0.5F}), -1);
  EXPECT_FLOAT_EQ(signed_distance_inside(square, {4, 5}), -5);  // to the corner
  EXPECT_FLOAT_EQ(signed_distance_inside({{0, 0}, {1, 0}}, {0.5F, 2}), -2);
  EXPECT_EQ(signed_distance_inside({}, {0, 0}), -std::numeric_limits<float>::infinity());
}

// The slow twin: the smallest of many fractions at which the point is inside.
TEST(FractionToInside, AgreesWithASearchByTheSignedDistance) {
  constexpr int kFractions = 2000;
  constexpr float kTolerance = 1.0F / kFractions + 1e-4F;
  std::mt19937 random(1);
  int between = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<Eigen::Vector2f> points;
    for (int k = 0; k < 8; ++k) points.emplace_back(tests::random_vector(random, 1).head<2>());
    const std::vector<Eigen::Vector2f> hull = convex_hull(points);
    for (int k = 0; k < 5; ++k) {
      const Eigen::Vector2f point = tests::random_vector(random, 1).head<2>();
      const Eigen::Vector2f goal = tests::random_vector(random, 0.3F).head<2>();
      const float margin = tests::uniform(random, 0, 0.3F);
      float expected = 1;
      for (int step = kFractions; step >= 0; --step) {
        const float fraction = static_cast<float>(step) / kFractions;
        if (signed_distance_inside(hull, point + fraction * (goal - point)) < margin) break;
        expected = fraction;
      }
      EXPECT_NEAR(fraction_to_inside(margin, hull, point, goal), expected, kTolerance);
      between += expected > 0 && expected < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(between, 50);
}

TEST(FractionToInside, IsNothingInsideAndAllWhereTheGoalIsOutside) {
  const std::vector<Eigen::Vector2f> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(fraction_to_inside(0.1F, square, {0.5F, 0.5F}, {0.5F, 0.6F}), 0);
  EXPECT_EQ(fraction_to_inside(0.1F, square, {-1, 0.5F}, {1, 0.5F}), 1);
  EXPECT_EQ(fraction_to_inside(0.1F, square, {0.5F, 0.5F}, {1, 0.5F}), 1);
  EXPECT_FLOAT_EQ(fraction_to_inside(0.1F, square, {-0.4F, 0.5F}, {0.6F, 0.5F}), 0.5F);
}

}  // namespace
}  // namespace flinch::motion
