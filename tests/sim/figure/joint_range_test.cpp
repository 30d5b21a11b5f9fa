// SPDX-License-Identifier: MIT
#include "sim/figure/joint_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/rotation.h"
#include "tests/motion/random_motion.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * kDegree, axis));
}

TEST(JointAngles, RoundTripToTheRotation) {
  std::mt19937 generator(3);
  for (Body body : motion::kBodies) {
    const JointRange limits = limits_of(body);
    for (int i = 0; i < 50; ++i) {
      const Eigen::Quaterniond rotation = tests::uniform_rotation(generator);
      const Eigen::Quaterniond back = joint_rotation(limits, joint_angles(limits, rotation));
      EXPECT_LT(back.angularDistance(rotation), 1e-9);
    }
  }
}

TEST(JointAngles, AreTheComponentsOfSwingAndTwist) {
  JointRange limits;
  limits.bone = -Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond rotation =
      about(Eigen::Vector3d::UnitY(), -70) * about(Eigen::Vector3d::UnitZ(), 20);
  const Eigen::Vector3d angles = joint_angles(limits, rotation) / kDegree;
  EXPECT_TRUE(angles.isApprox(Eigen::Vector3d(0, -70, 20), 1e-9)) << angles.transpose();
}

// Checks the signs of the table by where the bone goes.
TEST(JointRange, AllowsEverydayPoses) {
  const auto within = [](Body body, const Eigen::Quaterniond& rotation) {
    return limit_violation(limits_of(body), rotation, Eigen::Quaterniond::Identity()).norm() <
           1e-12;
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d down = -z;

  const Eigen::Quaterniond heel_back = about(y, 120);
  EXPECT_LT((heel_back * down).x(), 0);
  EXPECT_TRUE(within(Body::left_shin, heel_back));
  EXPECT_FALSE(within(Body::left_shin, about(y, -30)));
  EXPECT_FALSE(within(Body::right_shin, about(x, 20)));

  const Eigen::Quaterniond knee_up = about(y, -110);
  EXPECT_GT((knee_up * down).x(), 0);
  EXPECT_TRUE(within(Body::left_thigh, knee_up));
  EXPECT_FALSE(within(Body::left_thigh, about(y, 60)));
  const Eigen::Quaterniond leg_out = about(x, 40);
  EXPECT_GT((leg_out * down).y(), 0);
  EXPECT_TRUE(within(Body::left_thigh, leg_out));
  EXPECT_FALSE(within(Body::right_thigh, leg_out));
  EXPECT_TRUE(within(Body::right_thigh, about(x, -40)));

  const Eigen::Quaterniond forearm_forward = about(z, -140);
  EXPECT_GT((about(z, -90) * y).x(), 0.99);
  EXPECT_TRUE(within(Body::left_forearm, forearm_forward));
  EXPECT_FALSE(within(Body::left_forearm, about(z, 30)));
  EXPECT_TRUE(within(Body::right_forearm, about(z, 140)));
  EXPECT_FALSE(within(Body::right_forearm, about(z, -30)));

  EXPECT_TRUE(within(Body::head, about(y, 20)));
  EXPECT_FALSE(within(Body::head, about(y, 60)));
}

TEST(JointRange, ViolationLeadsBackToTheLimit) {
  const JointRange knee = limits_of(Body::left_shin);
  const Eigen::Vector3d back =
      limit_violation(knee, about(Eigen::Vector3d::UnitY(), 165), Eigen::Quaterniond::Identity());
  EXPECT_TRUE(back.isApprox(-15 * kDegree * Eigen::Vector3d::UnitY(), 1e-6)) << back.transpose();
}

TEST(JointRange, AllowsWhatTheReferenceDoes) {
  const JointRange knee = limits_of(Body::left_shin);
  const Eigen::Quaterniond reference = about(Eigen::Vector3d::UnitY(), 165);
  EXPECT_EQ(limit_violation(knee, about(Eigen::Vector3d::UnitY(), 163), reference).norm(), 0);
  EXPECT_NEAR(limit_violation(knee, about(Eigen::Vector3d::UnitY(), 170), reference).norm(),
              5 * kDegree, 1e-9);
}

TEST(JointRange, ViolationIsExactlyZeroWithinTheLimits) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> share(-0.3, 1.3);
  int within = 0;
  int beyond = 0;
  for (Body body : motion::kBodies) {
    if (!parent_of(body)) continue;
    const JointRange limits = limits_of(body);
    // The reference, at angles of 0, is allowed too.
    const Eigen::Vector3d low = limits.min.cwiseMin(0);
    const Eigen::Vector3d high = limits.max.cwiseMax(0);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d at(share(generator), share(generator), share(generator));
      const Eigen::Vector3d wanted = low + at.cwiseProduct(high - low);
      const Eigen::Quaterniond rotation = joint_rotation(limits, wanted);
      const Eigen::Vector3d angles = joint_angles(limits, rotation);
      if ((angles - wanted).norm() > 1e-6) continue;  // beyond half a turn
      const bool is_within = (angles - low).minCoeff() >= 0 && (high - angles).minCoeff() >= 0;
      (is_within ? within : beyond) += 1;
      // A quaternion and its negative are the same rotation.
      for (const double sign : {1.0, -1.0}) {
        const Eigen::Quaterniond same(sign * rotation.coeffs());
        EXPECT_EQ(limit_violation(limits, same, limits.reference).norm() == 0, is_within)
            << name_of(body) << " " << angles.transpose();
      }
    }
  }
  EXPECT_GT(within, 1000);
  EXPECT_GT(beyond, 1000);
}

// Angles jump at half a turn; the rotation back to the limits must not.
TEST(JointRange, ViolationIsNoLargerThanTheDistanceToTheReference) {
  std::mt19937 generator(8);
  std::normal_distribution<double> normal;
  for (Body body : motion::kBodies) {
    if (!parent_of(body)) continue;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Quaterniond reference = tests::uniform_rotation(generator);
      const Eigen::Vector3d turn(normal(generator), normal(generator), normal(generator));
      const Eigen::Quaterniond rotation =
          motion::rotation_from_vector<double>(0.05 * turn) * reference;
      EXPECT_LE(limit_violation(limits_of(body), rotation, reference).norm(),
                0.05 * turn.norm() + 1e-9);
    }
  }
}

}  // namespace
}  // namespace flinch::sim
