// SPDX-License-Identifier: MIT
#include "motion/interpolation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/clip.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using tests::random_pose;
using tests::random_rotation;
using tests::uniform;

TEST(EaseInEaseOut, StartsAndEndsAtRest) {
  EXPECT_EQ(ease_in_ease_out(0), 0);
  EXPECT_EQ(ease_in_ease_out(1), 1);
  EXPECT_EQ(ease_in_ease_out(-3), 0);
  EXPECT_EQ(ease_in_ease_out(7), 1);
  EXPECT_FLOAT_EQ(ease_in_ease_out(0.5F), 0.5F);
  const float h = 1e-3F;
  EXPECT_NEAR(ease_in_ease_out(h) / h, 0, 0.004F);
  EXPECT_NEAR((1 - ease_in_ease_out(1 - h)) / h, 0, 0.004F);
  EXPECT_NEAR((ease_in_ease_out(0.5F + h) - ease_in_ease_out(0.5F - h)) / (2 * h), 1.5F, 1e-3F);
}

TEST(Slerp, MatchesEigen) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaternionf a = random_rotation(random);
    const Eigen::Quaternionf b = random_rotation(random);
    const float weight = uniform(random, 0, 1);
    EXPECT_LT(slerp(a, b, weight).angularDistance(a.slerp(weight, b)), 2e-3F);
  }
}

TEST(Slerp, TakesTheShorterArcWhateverTheSigns) {
  const Eigen::Quaternionf a(Eigen::AngleAxisf(0.2F, Eigen::Vector3f::UnitZ()));
  Eigen::Quaternionf b(Eigen::AngleAxisf(1.2F, Eigen::Vector3f::UnitZ()));
  const Eigen::Quaternionf middle(Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitZ()));
  EXPECT_LT(slerp(a, b, 0.5F).angularDistance(middle), 1e-3F);
  b.coeffs() = -b.coeffs();
  EXPECT_LT(slerp(a, b, 0.5F).angularDistance(middle), 1e-3F);
}

TEST(Slerp, StaysUnitForNearlyEqualRotations) {
  const Eigen::Quaternionf a(Eigen::AngleAxisf(0.2F, Eigen::Vector3f::UnitZ()));
  const Eigen::Quaternionf b(Eigen::AngleAxisf(0.20001F, Eigen::Vector3f::UnitZ()));
  EXPECT_NEAR(slerp(a, b, 0.3F).norm(), 1, 1e-6F);
  EXPECT_LT(slerp(a, a, 0.3F).angularDistance(a), 1e-3F);
}

TEST(Blend, ReturnsTheEndPosesAtWeights0And1) {
  std::mt19937 random(2);
  const Pose a = random_pose(random);
  const Pose b = random_pose(random);
  EXPECT_LT(tests::distance(blend(a, b, 0), a), 1e-5F);
  EXPECT_LT(tests::distance(blend(a, b, 1), b), 1e-5F);
}

TEST(BlendAlong, IsTheBlendOfThoseSigns) {
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    const Pose a = random_pose(random, 1.5F);
    const Pose b = random_pose(random, 1.5F);
    Signs signs = shorter_arcs(a, b);
    const float weight = uniform(random, 0, 1);
    const Pose expected = blend(a, b, weight);
    const Pose pose = blend_along(a, b, weight, signs);
    Pose flipped = b;
    for (Role role : kRoles) {
      EXPECT_EQ(pose.rotation[role].coeffs(), expected.rotation[role].coeffs());
      if (random() % 2 == 0) flipped.rotation[role].coeffs() *= -1;
    }
    change_signs(b, flipped, kRoles, signs);
    const Pose again = blend_along(a, flipped, weight, signs);
    for (Role role : kRoles)
      EXPECT_EQ(again.rotation[role].coeffs(), expected.rotation[role].coeffs());
  }
}

// A joint that rotates from 170 to 190 degrees relative to the other passes a half turn, where the
// shorter arc changes sides and a plain blend jumps by about 180 degrees.
TEST(BlendAlongInitialArc, IsContinuousWhenTheShorterArcFlips) {
  const Pose still;
  const auto turned = [](float degrees) {
    Pose pose;
    pose.rotation[Role::left_upper_arm] =
        Eigen::AngleAxisf(degrees * 3.14159265F / 180, Eigen::Vector3f::UnitX());
    return pose;
  };
  Pose last = still;
  float jump = 0;
  float plain_jump = 0;
  Pose plain_last = still;
  for (int i = 0; i <= 100; ++i) {
    const float weight = 0.01F * static_cast<float>(i);
    Pose to = turned(170 + 0.2F * static_cast<float>(i));
    if (i % 2 == 1) to.rotation[Role::left_upper_arm].coeffs() *= -1;  // signs are arbitrary
    const Pose pose = blend_along_initial_arc(still, to, weight, still, turned(170));
    const Pose plain = blend(still, to, weight);
    jump = std::max(jump, tests::distance(pose, last));
    plain_jump = std::max(plain_jump, tests::distance(plain, plain_last));
    last = pose;
    plain_last = plain;
  }
  EXPECT_LT(jump, 0.05F);
  EXPECT_GT(plain_jump, 1);
  EXPECT_LT(tests::distance(last, turned(190)), 1e-3F);
}

TEST(BlendAlongInitialArc, EqualsBlendAtTheStart) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const Pose a = random_pose(random);
    const Pose b = random_pose(random);
    const float weight = uniform(random, 0, 1);
    EXPECT_LT(tests::distance(blend_along_initial_arc(a, b, weight, a, b), blend(a, b, weight)),
              1e-5F);
  }
}

}  // namespace
}  // namespace flinch::motion
