// SPDX-License-Identifier: MIT
#include "sim/sweep.h"

#include <algorithm>
#include <cmath>

namespace flinch::sim {
namespace {

/// From the nearest point of a capsule's axis.
Approach approach_capsule(const Eigen::Vector3d& centre, double radius,
                          const MovingShape& capsule) {
  const Eigen::Vector3d axis = capsule.orientation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d offset = centre - capsule.centre;
  const double along = std::clamp(offset.dot(axis), -capsule.half_length, capsule.half_length);
  const Eigen::Vector3d nearest = capsule.centre + along * axis;
  const Eigen::Vector3d separation = centre - nearest;
  const double distance = separation.norm();
  Approach result;
  if (distance > 0) result.normal = separation / distance;
  result.gap = distance - radius - capsule.radius;
  result.point = nearest + capsule.radius * result.normal;
  return result;
}

/// From the nearest point of a box; from inside, through the nearest face.
Approach approach_box(const Eigen::Vector3d& centre, double radius, const MovingShape& box) {
  const Eigen::Vector3d local = box.orientation.conjugate() * (centre - box.centre);
  Eigen::Vector3d nearest = local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  Eigen::Vector3d normal = local - nearest;
  double distance = normal.norm();
  if (distance > 0) {
    normal /= distance;
  } else {
    int face = 0;
    distance = -(box.half_extents - local.cwiseAbs()).minCoeff(&face);
    const double side = local[face] < 0 ? -1.0 : 1.0;
    normal = side * Eigen::Vector3d::Unit(face);
    nearest[face] = side * box.half_extents[face];
  }
  return {distance - radius, box.centre + box.orientation * nearest, box.orientation * normal};
}

}  // namespace

Eigen::Vector3d FreeFlight::position_at(double time_s) const {
  return position + time_s * velocity -
         0.5 * gravity_mps2 * time_s * time_s * Eigen::Vector3d::UnitZ();
}

MovingShape MovingShape::at(double time_s) const {
  MovingShape later = *this;
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

double MovingShape::reach() const {
  return kind == motion::Shape::Kind::capsule ? half_length : half_extents.norm();
}

Approach approach(const Eigen::Vector3d& ball_centre, double ball_radius,
                  const MovingShape& shape) {
  return shape.kind == motion::Shape::Kind::capsule
             ? approach_capsule(ball_centre, ball_radius, shape)
             : approach_box(ball_centre, ball_radius, shape);
}

// |d gap / dt| <= |v_ball - v_shape| + g T + |w| reach, and the slack grows by at most a T.
std::optional<double> time_of_touch(const FreeFlight& ball, const MovingShape& shape,
                                    double horizon_s, double touch_m, double slack_mps2) {
  const double rate = (ball.velocity - shape.velocity).norm() +
                      (ball.gravity_mps2 + slack_mps2) * horizon_s +
                      shape.angular_velocity.norm() * shape.reach();
  double time_s = 0;
  while (time_s <= horizon_s) {
    const double gap = approach(ball.position_at(time_s), ball.radius, shape.at(time_s)).gap -
                       0.5 * slack_mps2 * time_s * time_s;
    if (gap <= touch_m) return time_s;
    if (rate <= 0) return std::nullopt;
    // Half of touch_m may be skipped too: it keeps a ball that glides past from taking for ever.
    time_s += (gap - 0.5 * touch_m) / rate;
  }
  return std::nullopt;
}

// z + v t - g t^2 / 2 = r + touch; the later root is the falling one.
std::optional<double> time_of_bounce(const FreeFlight& ball, double horizon_s, double touch_m) {
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

}  // namespace flinch::sim
