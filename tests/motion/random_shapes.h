// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "features/ball.h"
#include "motion/collision_shape.h"

namespace flinch::tests {

/// Random outlines near the origin, and balls that fly at them.
class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : generator_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Eigen::Vector3d vector(double max) {
    const double x = number(-max, max);
    const double y = number(-max, max);
    const double z = number(-max, max);
    return {x, y, z};
  }

  motion::CollisionShape outline() {
    motion::CollisionShape outline;
    outline.kind = number(0, 1) < 0.5 ? motion::Shape::Kind::capsule : motion::Shape::Kind::box;
    outline.radius = number(0.02, 0.15);
    outline.half_length = number(0, 0.3);
    outline.half_extents = {number(0.01, 0.2), number(0.01, 0.2), number(0.01, 0.2)};
    outline.centre = vector(0.3);
    outline.orientation =
        Eigen::Quaterniond(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)).normalized();
    return outline;
  }

  features::Ball ball() {
    features::Ball ball;
    ball.position = vector(1);
    ball.velocity = 25 * (vector(0.3) - ball.position).normalized() + vector(3);
    ball.radius = number(0.03, 0.15);
    return ball;
  }

 private:
  std::mt19937 generator_;
};

}  // namespace flinch::tests
