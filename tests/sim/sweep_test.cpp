// SPDX-License-Identifier: MIT
#include "sim/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace flinch::sim {
namespace {

constexpr double kHorizon_s = 0.05;
constexpr double kTouch_m = 1e-4;

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : generator_(seed) {}

  Eigen::Vector3d vector(double most) {
    return {number(-most, most), number(-most, most), number(-most, most)};
  }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }

  MovingShape shape() {
    MovingShape shape;
    shape.kind = number(0, 1) < 0.5 ? motion::Shape::Kind::capsule : motion::Shape::Kind::box;
    shape.radius = number(0.02, 0.15);
    shape.half_length = number(0, 0.3);
    shape.half_extents = {number(0.01, 0.2), number(0.01, 0.2), number(0.01, 0.2)};
    shape.centre = vector(0.3);
    shape.orientation =
        Eigen::Quaterniond(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)).normalized();
    shape.velocity = vector(5);
    shape.angular_velocity = vector(15);
    return shape;
  }

  FreeFlight ball() {
    FreeFlight ball;
    ball.position = vector(1);
    ball.velocity = 25 * (vector(0.3) - ball.position).normalized() + vector(3);
    ball.radius = number(0.03, 0.15);
    ball.gravity_mps2 = 9.81;
    return ball;
  }

 private:
  std::mt19937 generator_;
};

/// A point of the surface or inside, by its definition rather than by the code under test.
bool contains(const MovingShape& shape, const Eigen::Vector3d& point) {
  const Eigen::Vector3d local = shape.orientation.conjugate() * (point - shape.centre);
  if (shape.kind == motion::Shape::Kind::box) {
    return ((shape.half_extents - local.cwiseAbs()).array() >= 0).all();
  }
  const double along = std::clamp(local.z(), -shape.half_length, shape.half_length);
  return (local - Eigen::Vector3d(0, 0, along)).norm() <= shape.radius;
}

TEST(Approach, GapIsTheRadiusAtWhichTheBallFirstReachesTheShape) {
  RandomScene random(11);
  for (int i = 0; i < 300; ++i) {
    const MovingShape shape = random.shape();
    const Eigen::Vector3d centre = random.vector(0.8);
    const Approach near = approach(centre, 0, shape);
    if (near.gap <= 0) {
      EXPECT_TRUE(contains(shape, centre));
      continue;
    }
    EXPECT_FALSE(contains(shape, centre));
    EXPECT_NEAR((centre - near.point).norm(), near.gap, 1e-12);
    EXPECT_TRUE(contains(shape, near.point - 1e-9 * near.normal));
    // No point of a ball of nearly that radius is in the shape.
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d inside = 0.999 * near.gap * random.vector(1).normalized();
      EXPECT_FALSE(contains(shape, centre + inside));
    }
  }
}

TEST(Approach, FromInsideABoxGoesThroughTheNearestFace) {
  MovingShape box;
  box.kind = motion::Shape::Kind::box;
  box.half_extents = {0.3, 0.2, 0.1};
  const Approach near = approach({0.05, 0.05, -0.08}, 0.01, box);
  EXPECT_NEAR(near.gap, -0.03, 1e-12);
  EXPECT_TRUE(near.normal.isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(near.point.isApprox(Eigen::Vector3d(0.05, 0.05, -0.1)));
}

// Against the path sampled so finely that a gap changes by less than a tenth of the touch between
// samples.
TEST(TimeOfTouch, AgreesWithFineSampling) {
  RandomScene random(5);
  int touched = 0;
  int missed = 0;
  for (int i = 0; i < 400; ++i) {
    const FreeFlight ball = random.ball();
    const MovingShape shape = random.shape();
    const auto found = time_of_touch(ball, shape, kHorizon_s, kTouch_m, 0);
    constexpr int kSamples = 20000;
    std::optional<double> sampled;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kSamples && !sampled; ++k) {
      const double time_s = kHorizon_s * k / kSamples;
      const double gap = approach(ball.position_at(time_s), ball.radius, shape.at(time_s)).gap;
      least = std::min(least, gap);
      if (gap <= 0.5 * kTouch_m) sampled = time_s;
    }
    if (sampled) {
      ASSERT_TRUE(found) << "missed a touch at " << *sampled;
      EXPECT_LE(*found, *sampled);
      // At the time found the surfaces do touch.
      EXPECT_LE(approach(ball.position_at(*found), ball.radius, shape.at(*found)).gap, kTouch_m);
      ++touched;
    } else if (least > 1.1 * kTouch_m) {
      EXPECT_FALSE(found);
      ++missed;
    }
  }
  EXPECT_GT(touched, 50);
  EXPECT_GT(missed, 50);
}

// Whatever accelerations up to the slack a shape has, it is not touched before the time found.
TEST(TimeOfTouch, WithSlackIsSafeForAcceleratingShapes) {
  RandomScene random(6);
  constexpr double kSlack_mps2 = 100;
  int touched = 0;
  for (int i = 0; i < 200; ++i) {
    const FreeFlight ball = random.ball();
    const MovingShape shape = random.shape();
    const Eigen::Vector3d acceleration = kSlack_mps2 * random.vector(1).normalized();
    const double safe_s =
        time_of_touch(ball, shape, kHorizon_s, kTouch_m, kSlack_mps2).value_or(kHorizon_s);
    for (int k = 0; k < 1000; ++k) {
      const double time_s = safe_s * k / 1000;
      MovingShape accelerated = shape.at(time_s);
      accelerated.centre += 0.5 * time_s * time_s * acceleration;
      EXPECT_GT(approach(ball.position_at(time_s), ball.radius, accelerated).gap, 0);
    }
    if (safe_s < kHorizon_s) ++touched;
  }
  EXPECT_GT(touched, 50);
}

TEST(TimeOfBounce, IsWhenAFallingBallReachesTheGround) {
  FreeFlight ball;
  ball.position = {0, 0, 1.1};
  ball.radius = 0.1;
  ball.gravity_mps2 = 10;
  // 1 m of free fall: sqrt(2 / 10) s.
  const auto fallen = time_of_bounce(ball, 1, 0);
  ASSERT_TRUE(fallen);
  EXPECT_NEAR(*fallen, std::sqrt(0.2), 1e-12);
  EXPECT_FALSE(time_of_bounce(ball, 0.4, 0));

  ball.position.z() = 0.1;
  ball.velocity.z() = 5;
  const auto thrown = time_of_bounce(ball, 2, 0);
  ASSERT_TRUE(thrown);
  EXPECT_NEAR(*thrown, 1, 1e-12);
}

}  // namespace
}  // namespace flinch::sim
