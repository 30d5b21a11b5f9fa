// SPDX-License-Identifier: MIT
#include "sim/contact/contact_constraint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flinch::sim {
namespace {

constexpr features::Bounce kBounce;
const Eigen::Vector3d kNormal = Eigen::Vector3d(1, 2, -0.5).normalized();
const Eigen::Vector3d kPoint(0.3, -0.2, 1.1);

Eigen::Vector3d tangent_of(const BodyState& ball, const BodyState& part) {
  return impact_constraint(kPoint, kNormal, ball, part, kBounce).tangent;
}

TEST(ImpactConstraint, TangentIsAlongTheVelocityOfSlidingWithTheSpinOfBoth) {
  BodyState ball;
  ball.position = kPoint + 0.1 * kNormal;
  ball.velocity = {-9, 4, 2};
  ball.angular_velocity = {30, -20, 10};
  BodyState part;
  part.position = {0.2, -0.4, 1.2};
  part.velocity = {1, -2, 0.5};
  part.angular_velocity = {-3, 5, 8};
  const Eigen::Vector3d relative =
      ball.velocity + ball.angular_velocity.cross(kPoint - ball.position) - part.velocity -
      part.angular_velocity.cross(kPoint - part.position);
  const Eigen::Vector3d tangent = tangent_of(ball, part);
  EXPECT_NEAR(tangent.norm(), 1, 1e-12);
  EXPECT_NEAR(tangent.dot(kNormal), 0, 1e-12);
  EXPECT_NEAR(tangent.dot(relative),
              std::sqrt(relative.squaredNorm() - std::pow(relative.dot(kNormal), 2)), 1e-12);
}

TEST(ImpactConstraint, WithoutSlidingTheTangentTurnsWithThePart) {
  BodyState ball;
  ball.position = kPoint + 0.1 * kNormal;
  ball.velocity = -12 * kNormal;
  for (int i = 0; i < 16; ++i) {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(i * std::numbers::pi / 8, Eigen::Vector3d(1, -2, 3).normalized()));
    BodyState turned_ball;
    turned_ball.velocity = turn * ball.velocity;
    BodyState part;
    part.orientation = Eigen::Quaterniond(0.6, 0.48, 0, 0.64);
    const Eigen::Vector3d expected = turn * tangent_of(ball, part);
    part.orientation = turn * part.orientation;
    const Eigen::Vector3d found =
        impact_constraint(Eigen::Vector3d::Zero(), turn * kNormal, turned_ball, part, kBounce)
            .tangent;
    EXPECT_LT((found - expected).norm(), 1e-12) << i;
    EXPECT_NEAR(found.dot(turn * kNormal), 0, 1e-12);
  }
}

TEST(BounceConstraint, TangentIsAlongTheBallsPathOverTheGround) {
  BodyState ball;
  ball.position = {3, 4, 0.105};
  ball.velocity = {6, -8, -5};
  const ContactConstraint bounce = bounce_constraint(ball, Eigen::Quaterniond::Identity(), kBounce);
  EXPECT_LT((bounce.tangent - Eigen::Vector3d(0.6, -0.8, 0)).norm(), 1e-12);
  EXPECT_EQ(bounce.point, Eigen::Vector3d(3, 4, 0));
}

}  // namespace
}  // namespace flinch::sim
