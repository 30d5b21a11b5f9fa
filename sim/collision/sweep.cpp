// SPDX-License-Identifier: MIT
#include "sim/collision/sweep.h"

#include <algorithm>

#include "features/ball_clearance.h"

namespace flinch::sim {

MovingShape MovingShape::at(double time_s) const {
  MovingShape later = *this;
  if (time_s == 0) return later;
  later.centre += time_s * velocity;
  const double speed = angular_velocity.norm();
  if (speed > 0) {
    const Eigen::AngleAxisd turn(speed * time_s, angular_velocity / speed);
    later.orientation = turn * orientation;
  }
  return later;
}

Eigen::Vector3d MovingShape::velocity_at(const Eigen::Vector3d& point) const {
  return velocity + angular_velocity.cross(point - centre);
}

bool may_be_near(const features::Ball& ball, const MovingShape& shape, double distance_m) {
  const double max_distance = shape.bounding_radius() + ball.bounding_radius() + distance_m;
  return (ball.position - shape.centre).squaredNorm() <= max_distance * max_distance;
}

// |d gap / dt| <= |v_ball - v_shape| + g T + |w| reach, and the slack grows by at most a T. A rod
// adds its own turning.
std::optional<double> time_of_contact(const features::Ball& ball, const MovingShape& shape,
                                      double horizon_s, double contact_distance_m,
                                      double slack_mps2) {
  const double rate = (ball.pivot_velocity() - shape.velocity).norm() + ball.turning_mps() +
                      (ball.gravity_mps2 + slack_mps2) * horizon_s +
                      shape.angular_velocity.norm() * shape.reach();
  const double max_distance_m =
      contact_distance_m + (rate + 0.5 * slack_mps2 * horizon_s) * horizon_s;
  if (!may_be_near(ball, shape, max_distance_m)) return std::nullopt;
  double time_s = std::max(ball.window.from_s, 0.0);
  const double end_s = std::min(horizon_s, ball.window.until_s);
  while (time_s <= end_s) {
    const double gap =
        features::gap_at(ball, time_s, shape.at(time_s)) - 0.5 * slack_mps2 * time_s * time_s;
    if (gap <= contact_distance_m) return time_s;
    if (rate <= 0) return std::nullopt;
    // Half of touch_m is skipped too; otherwise a ball that glides past would take very many
    // iterations.
    time_s += (gap - 0.5 * contact_distance_m) / rate;
  }
  return std::nullopt;
}

}  // namespace flinch::sim
