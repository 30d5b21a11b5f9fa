// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "motion/body.h"

namespace flinch::sim {

/// A ball in free flight: x(t) = x + v t - g t^2 / 2 z. World frame.
struct FreeFlight {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = 0;                                   ///< m
  double gravity_mps2 = 0;

  Eigen::Vector3d position_at(double time_s) const;
};

/// An outline that moves as a rigid body does, without acceleration. World frame, at its centre.
struct MovingShape {
  motion::Shape::Kind kind = motion::Shape::Kind::capsule;
  double radius = 0;                                                ///< of a capsule, m
  double half_length = 0;                                           ///< of a capsule, m
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();           ///< of a box, m
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();                 ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< of the centre, m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< rad/s

  MovingShape at(double time_s) const;
  /// Velocity of the material point that is now at `point`, m/s.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& point) const;
  /// How far the farthest point that can touch is moved by a turn about the centre, m.
  double reach() const;
};

/// Where two surfaces are closest.
struct Approach {
  double gap = 0;                                     ///< m, negative where they overlap
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< on the shape's surface
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from the shape to the ball
};

/// How near a ball is to a shape.
Approach approach(const Eigen::Vector3d& ball_centre, double ball_radius, const MovingShape& shape);

/// The first time in [0, horizon_s] at which the gap between ball and shape is at most
///
///     touch_m + slack_mps2 t^2 / 2,
///
/// the last term for a shape that may accelerate by up to `slack_mps2`; nothing if there is none.
/// Never late; early by no more than the time in which the gap changes by touch_m. By conservative
/// advancement: the gap divided by a bound of its rate is safe to skip.
std::optional<double> time_of_touch(const FreeFlight& ball, const MovingShape& shape,
                                    double horizon_s, double touch_m, double slack_mps2);

/// The first time in [0, horizon_s] at which the ball comes within touch_m of the ground, falling.
std::optional<double> time_of_bounce(const FreeFlight& ball, double horizon_s, double touch_m);

}  // namespace flinch::sim
