// SPDX-License-Identifier: MIT
#include "motion/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

TEST(Rotated, HasTheBitsOfEigensProduct) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaternionf rotation = tests::random_rotation(random);
    const Eigen::Vector3f vector = tests::random_vector(random, 2);
    EXPECT_EQ(rotated(vector, rotation), rotation * vector);
  }
}

TEST(RotationVector, IsAtMostPiLongAndInvertible) {
  std::mt19937 generator(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond rotation = tests::uniform_rotation(generator);
    const Eigen::Vector3d vector = rotation_vector(rotation);
    EXPECT_LE(vector.norm(), std::numbers::pi + 1e-12);
    EXPECT_LT(rotation_from_vector<double>(vector).angularDistance(rotation), 1e-9);
  }
}

TEST(RotationVector, IsZeroForTheIdentity) {
  EXPECT_EQ(rotation_vector(Eigen::Quaternionf::Identity()).norm(), 0);
  const Eigen::Vector3f tiny(1e-20F, 0, 0);
  EXPECT_TRUE(rotation_from_vector<float>(tiny).coeffs().allFinite());
}

TEST(RotationBetween, IsTheShortestRotationBetweenTwoDirections) {
  std::mt19937 generator(6);
  const Eigen::Vector3d from(0.3, -2, 1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d to = tests::uniform_rotation(generator) * from;
    const Eigen::Quaterniond rotation = rotation_between<double>(from, 3 * to);
    EXPECT_LT((rotation * from - to).norm(), 1e-9);
    const double angle = std::acos(std::clamp(from.dot(to) / from.squaredNorm(), -1.0, 1.0));
    EXPECT_NEAR(rotation_vector(rotation).norm(), angle, 1e-7);
  }
}

TEST(RotationBetween, IsAHalfTurnForOppositeDirections) {
  const Eigen::Vector3f from(0.3F, -2, 1);
  const Eigen::Quaternionf rotation = rotation_between<float>(from, -from);
  EXPECT_LT((rotation * from + from).norm(), 1e-5F);
  EXPECT_NEAR(rotation.vec().dot(from), 0, 1e-5F);
}

// Angles from opposite down to the rounding of a float and beyond, against double precision. The
// axis is across both directions, so that the way is the shortest.
TEST(RotationBetween, IsAccurateNearOppositeDirections) {
  std::mt19937 generator(7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d from = tests::uniform_rotation(generator) * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d across = from.unitOrthogonal();
    const double short_of = std::pow(10.0, 0.4 - 0.05 * i);
    const Eigen::Vector3f a = from.cast<float>();
    const Eigen::Vector3f b =
        (-std::cos(short_of) * from + std::sin(short_of) * across).cast<float>();
    const Eigen::Quaterniond rotation = rotation_between<float>(a, b).cast<double>();
    const Eigen::Vector3d exact_a = a.cast<double>().normalized();
    const Eigen::Vector3d exact_b = b.cast<double>().normalized();
    EXPECT_NEAR(rotation.norm(), 1, 1e-6);
    EXPECT_LT((rotation * exact_a - exact_b).norm(), 2e-6) << short_of;
    const double angle = std::atan2(exact_a.cross(exact_b).norm(), exact_a.dot(exact_b));
    EXPECT_NEAR(2 * std::atan2(rotation.vec().norm(), rotation.w()), angle, 2e-6) << short_of;
    EXPECT_NEAR(rotation.vec().dot(exact_a - exact_b), 0, 2e-6) << short_of;
  }
}

TEST(SwingTwist, RecomposesTheRotationAboutAnyAxis) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond rotation = tests::uniform_rotation(generator);
    const Eigen::Vector3d axis =
        Eigen::Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
    const Eigen::Vector3d angles = swing_twist_vector<double>(rotation, axis);
    EXPECT_LT(rotation_from_swing_twist<double>(angles, axis).angularDistance(rotation), 1e-9);
  }
}

}  // namespace
}  // namespace flinch::motion
