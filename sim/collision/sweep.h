// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "features/ball.h"
#include "motion/collision_shape.h"

namespace flinch::sim {

/// A collision shape that moves as a rigid body without acceleration. World frame, at its centre.
struct MovingShape : motion::CollisionShape {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< of the centre, m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s

  MovingShape at(double time_s) const;
  /// Radius of the sphere about the centre that contains the shape, m.
  double bounding_radius() const { return reach() + radius; }
  /// Velocity of the material point that is now at `point`, m/s.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& point) const;
};

/// Whether ball and shape may be within `distance_m` of each other, tested with the shape's
/// bounding sphere in a fraction of the time that the clearance takes. Never misses one that is.
bool may_be_near(const features::Ball& ball, const MovingShape& shape, double distance_m);

/// Returns the first time in [0, horizon_s], within the ball's window, at which the gap between
/// ball and shape is at most
///
///     touch_m + slack_mps2 t^2 / 2,
///
/// where the last term covers a shape that may accelerate by up to `slack_mps2`, or nothing if
/// there is none. The result is never late, and early by at most the time in which the gap changes
/// by touch_m. Uses conservative advancement: skipping the gap divided by an upper bound of its
/// rate is safe.
std::optional<double> time_of_contact(const features::Ball& ball, const MovingShape& shape,
                                      double horizon_s, double contact_distance_m,
                                      double slack_mps2);

}  // namespace flinch::sim
