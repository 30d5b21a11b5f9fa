// SPDX-License-Identifier: MIT
#include "sim/contact/next_step.h"

#include <gtest/gtest.h>

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kRadius_m = 0.1;

MovingShape sphere_at(const Eigen::Vector3d& centre) {
  MovingShape shape;
  shape.kind = motion::Shape::Kind::capsule;
  shape.radius = kRadius_m;
  shape.half_length = 0;
  shape.centre = centre;
  return shape;
}

/// A dead ball at the origin on the chest, which is in front of it; all else is far away.
class RestingStepTest : public testing::Test {
 protected:
  RestingStepTest() {
    ball_.radius = kRadius_m;
    ball_.gravity_mps2 = 0;
    ball_.bounce = {0.2, 0.5};
    for (const Body body : motion::kBodies) shapes_[body] = sphere_at({50, 0, 0});
    shapes_[Body::chest] = sphere_at({2 * kRadius_m, 0, 0});
  }

  double step_s() const { return resting_step(ball_, shapes_, kAllBodies, options_); }

  features::Ball ball_;
  motion::PerBody<MovingShape> shapes_;
  SimulationOptions options_;
};

TEST_F(RestingStepTest, WhatRestsIsPushedInLongSteps) {
  ball_.velocity.x() = 0.1;
  EXPECT_DOUBLE_EQ(step_s(), options_.resting_step_s);
}

TEST_F(RestingStepTest, WhatStrikesOrBouncesIsNot) {
  ball_.velocity.x() = 0.3;
  EXPECT_DOUBLE_EQ(step_s(), options_.contact_step_s);
  ball_.velocity.x() = 0.1;
  ball_.bounce.restitution = 0.7;
  EXPECT_DOUBLE_EQ(step_s(), options_.contact_step_s);
}

// A second body that leaves what it has touched is no contact that is to come.
TEST_F(RestingStepTest, ABodyThatSeparatesShortensNoStep) {
  ball_.velocity.x() = 0.1;
  shapes_[Body::abdomen] = sphere_at({0, -2 * kRadius_m, 0});
  shapes_[Body::abdomen].velocity.y() = -0.5;
  EXPECT_DOUBLE_EQ(step_s(), options_.resting_step_s);
}

TEST_F(RestingStepTest, AStepEndsWhereAnotherBodyIsMet) {
  ball_.velocity.x() = 0.1;
  shapes_[Body::abdomen] = sphere_at({0, -2 * kRadius_m - 0.01, 0});
  shapes_[Body::abdomen].velocity.y() = 1;
  EXPECT_NEAR(step_s(), 0.01, 2e-4);
}

TEST_F(RestingStepTest, ARodTurnsByThreeDegreesAtMost) {
  ball_.rod.axis = Eigen::Vector3d::UnitZ();
  ball_.rod.to_butt_m = 0.3;
  ball_.rod.to_tip_m = 0.3;
  ball_.rod.angular_velocity = {10, 0, 0};
  ball_.velocity.x() = 0.1;
  EXPECT_NEAR(step_s(), 0.005, 1e-9);
  ball_.rod.angular_velocity.setZero();
  EXPECT_DOUBLE_EQ(step_s(), options_.resting_step_s);
}

}  // namespace
}  // namespace flinch::sim
