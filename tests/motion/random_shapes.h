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

  /// A rod that flies at the outlines and turns, about its middle or about a grip.
  features::Ball rod() {
    features::Threat threat;
    threat.radius = 0.03F;
    threat.mass_kg = 1;
    features::Rod rod;
    rod.axis = vector(1).normalized().cast<float>();
    const Eigen::Vector3f turn = (20 * vector(1)).cast<float>();
    rod.angular_velocity = turn - turn.dot(rod.axis) * rod.axis;
    if (number(0, 1) < 0.5) {
      rod.to_butt_m = 0.1F;
      rod.to_tip_m = 0.7F;
      rod.to_mass_m = 0.4F;
      rod.grip_mass_kg = 2;
      threat.stroke = features::Stroke{0, 10};
    }
    threat.rod = rod;
    const Eigen::Vector3d position = vector(1);
    threat.position = position.cast<float>();
    threat.velocity = (20 * (vector(0.3) - position).normalized() + vector(3)).cast<float>();
    features::Ball ball = features::ball_of(threat);
    ball.window = {};
    return ball;
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
