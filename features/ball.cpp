// SPDX-License-Identifier: MIT
#include "features/ball.h"

#include <algorithm>
#include <cmath>

namespace flinch::features {

Eigen::Vector3d Ball::position_at(double time_s) const {
  return position + time_s * velocity -
         0.5 * gravity_mps2 * time_s * time_s * Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d Ball::velocity_at(double time_s) const {
  return velocity - gravity_mps2 * time_s * Eigen::Vector3d::UnitZ();
}

Ball Ball::at(double time_s) const {
  Ball later = *this;
  later.position = position_at(time_s);
  later.velocity = velocity_at(time_s);
  later.window = window.at(time_s);
  return later;
}

Ball ball_of(const Threat& threat, double gravity_mps2) {
  Ball ball{threat.position.cast<double>(),
            threat.velocity.cast<double>(),
            static_cast<double>(threat.radius),
            static_cast<double>(threat.mass_kg),
            threat.falls && !threat.stroke ? gravity_mps2 : 0,
            threat.bounce,
            {}};
  if (threat.stroke) {
    const double starts_in_s = double{threat.stroke->starts_in_s};
    ball.position -= starts_in_s * ball.velocity;
    ball.window = {starts_in_s, starts_in_s + double{threat.stroke->lasts_s}};
  }
  return ball;
}

double moment_of_inertia(const Ball& ball) {
  return 2.0 / 3 * ball.mass_kg * ball.radius * ball.radius;
}

// z + v t - g t^2 / 2 = r + touch; at the later root the ball falls.
std::optional<double> time_of_bounce(const Ball& ball, double horizon_s, double touch_m) {
  const double height = ball.position.z() - ball.radius - touch_m;
  const double rise = ball.velocity.z();
  if (ball.gravity_mps2 <= 0) {
    if (rise >= 0) return std::nullopt;
    const double time_s = std::max(-height / rise, 0.0);
    return time_s <= horizon_s ? std::optional(time_s) : std::nullopt;
  }
  const double discriminant = rise * rise + 2 * ball.gravity_mps2 * height;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double time_s = std::max((rise + root) / ball.gravity_mps2, 0.0);
  return time_s <= horizon_s ? std::optional(time_s) : std::nullopt;
}

}  // namespace flinch::features
