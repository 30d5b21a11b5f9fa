// SPDX-License-Identifier: MIT
#include "motion/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

TEST(Turned, HasTheBitsOfEigensProduct) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaternionf rotation = tests::random_rotation(random);
    const Eigen::Vector3f vector = tests::random_vector(random, 2);
    EXPECT_EQ(turned(vector, rotation), rotation * vector);
  }
}

TEST(RotationVector, TakesTheShorterWayAndComesBack) {
  std::mt19937 generator(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond rotation = tests::uniform_rotation(generator);
    const Eigen::Vector3d vector = rotation_vector(rotation);
    EXPECT_LE(vector.norm(), std::numbers::pi + 1e-12);
    EXPECT_LT(rotation_by<double>(vector).angularDistance(rotation), 1e-9);
  }
}

TEST(RotationVector, OfNoRotationIsZeroInFloatToo) {
  EXPECT_EQ(rotation_vector(Eigen::Quaternionf::Identity()).norm(), 0);
  const Eigen::Vector3f tiny(1e-20F, 0, 0);
  EXPECT_TRUE(rotation_by<float>(tiny).coeffs().allFinite());
}

TEST(RotationBetween, TakesOneDirectionToTheOtherByTheShortestWay) {
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

TEST(RotationBetween, OfOppositeDirectionsIsAHalfTurnAcross) {
  const Eigen::Vector3f from(0.3F, -2, 1);
  const Eigen::Quaternionf rotation = rotation_between<float>(from, -from);
  EXPECT_LT((rotation * from + from).norm(), 1e-5F);
  EXPECT_NEAR(rotation.vec().dot(from), 0, 1e-5F);
}

TEST(SwingAndTwist, GiveTheRotationBackAboutAnyAxis) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond rotation = tests::uniform_rotation(generator);
    const Eigen::Vector3d axis =
        Eigen::Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
    const Eigen::Vector3d angles = swing_and_twist<double>(rotation, axis);
    EXPECT_LT(from_swing_and_twist<double>(angles, axis).angularDistance(rotation), 1e-9);
  }
}

}  // namespace
}  // namespace flinch::motion
