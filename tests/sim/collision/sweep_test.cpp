// SPDX-License-Identifier: MIT
#include "sim/collision/sweep.h"

#include <gtest/gtest.h>

#include <limits>

#include "features/ball_clearance.h"
#include "tests/motion/random_shapes.h"

namespace flinch::sim {
namespace {

constexpr double kHorizon_s = 0.05;
constexpr double kTestContactDistance_m = 1e-4;

class RandomScene : public tests::RandomShapes {
 public:
  using RandomShapes::RandomShapes;

  MovingShape shape() {
    MovingShape shape{outline()};
    shape.velocity = vector(5);
    shape.angular_velocity = vector(15);
    return shape;
  }
};

// Compares with the path sampled so finely that a gap changes by less than a tenth of the contact
// distance between samples; that of a rod is the least along its axis.
TEST(TimeOfContact, MatchesFineSampling) {
  RandomScene random(5);
  int touched = 0;
  int missed = 0;
  for (int i = 0; i < 600; ++i) {
    const features::Ball ball = i < 400 ? random.ball() : random.rod();
    const MovingShape shape = random.shape();
    const auto found = time_of_contact(ball, shape, kHorizon_s, kTestContactDistance_m, 0);
    constexpr int kSamples = 20000;
    std::optional<double> sampled;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kSamples && !sampled; ++k) {
      const double time_s = kHorizon_s * k / kSamples;
      const double gap = clearance(ball.at(time_s), shape.at(time_s)).gap;
      least = std::min(least, gap);
      if (gap <= 0.5 * kTestContactDistance_m) sampled = time_s;
    }
    if (sampled) {
      ASSERT_TRUE(found) << "missed a touch at " << *sampled;
      EXPECT_LE(*found, *sampled);
      // At the time found, the surfaces do touch.
      EXPECT_LE(clearance(ball.at(*found), shape.at(*found)).gap, kTestContactDistance_m);
      ++touched;
    } else if (least > 1.1 * kTestContactDistance_m) {
      EXPECT_FALSE(found);
      ++missed;
    }
  }
  EXPECT_GT(touched, 50);
  EXPECT_GT(missed, 50);
}

// A shape with any accelerations up to the slack is not touched before the time found.
TEST(TimeOfContact, IsNeverLateForAcceleratingShapes) {
  RandomScene random(6);
  constexpr double kSlack_mps2 = 100;
  int touched = 0;
  for (int i = 0; i < 200; ++i) {
    const features::Ball ball = random.ball();
    const MovingShape shape = random.shape();
    const Eigen::Vector3d acceleration = kSlack_mps2 * random.vector(1).normalized();
    const double safe_s =
        time_of_contact(ball, shape, kHorizon_s, kTestContactDistance_m, kSlack_mps2)
            .value_or(kHorizon_s);
    for (int k = 0; k < 1000; ++k) {
      const double time_s = safe_s * k / 1000;
      MovingShape accelerated = shape.at(time_s);
      accelerated.centre += 0.5 * time_s * time_s * acceleration;
      EXPECT_GT(clearance(ball.position_at(time_s), ball.radius, accelerated).gap, 0);
    }
    if (safe_s < kHorizon_s) ++touched;
  }
  EXPECT_GT(touched, 50);
}

}  // namespace
}  // namespace flinch::sim
