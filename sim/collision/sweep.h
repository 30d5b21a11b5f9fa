// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "features/free_flight.h"
#include "motion/collision_shape.h"

namespace flinch::sim {

/// An outline that moves as a rigid body does, without acceleration. World frame, at its centre.
struct MovingShape : motion::CollisionShape {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< of the centre, m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s

  MovingShape at(double time_s) const;
  /// Of the sphere about the centre that holds it, m.
  double bounding_radius() const { return reach() + radius; }
  /// Velocity of the material point that is now at `point`, m/s.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& point) const;
};

/// Whether they may be within `distance_m` of each other: by the sphere about the shape, in a
/// fraction of the time that the clearance takes.
bool may_be_near(const features::FreeFlight& ball, const MovingShape& shape, double distance_m);

/// The first time in [0, horizon_s] at which the gap between ball and shape is at most
///
///     touch_m + slack_mps2 t^2 / 2,
///
/// the last term for a shape that may accelerate by up to `slack_mps2`; nothing if there is none.
/// Never late; early by no more than the time in which the gap changes by touch_m. By conservative
/// advancement: the gap divided by a bound of its rate is safe to skip.
std::optional<double> time_of_contact(const features::FreeFlight& ball, const MovingShape& shape,
                                      double horizon_s, double contact_distance_m,
                                      double slack_mps2);

}  // namespace flinch::sim
