// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "features/threat.h"

namespace flinch::features {

/// A ball as physics moves it, and its free flight: x(t) = x + v t - g t^2 / 2 z. World frame, Z
/// up.
struct Ball {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = kVolleyballRadius_m;                 ///< m
  double mass_kg = kVolleyballMass_kg;
  double gravity_mps2 = kGravity_mps2;  ///< downwards; 0 for a ball that flies straight
  Bounce bounce{};

  /// The position `time_s` later: x + v t - g t^2 / 2 z.
  Eigen::Vector3d position_at(double time_s) const;
  /// The velocity then: v - g t z.
  Eigen::Vector3d velocity_at(double time_s) const;
  /// The ball `time_s` later: its position and velocity then.
  Ball at(double time_s) const;
};

/// The ball that a threat is, with its current position and velocity. `gravity_mps2` is that of one
/// that falls.
Ball ball_of(const Threat& threat, double gravity_mps2 = kGravity_mps2);

/// The moment of inertia of a ball about any axis, kg m^2, as a thin spherical shell: 2/3 m r^2.
double moment_of_inertia(const Ball& ball);

/// Returns the first time in [0, horizon_s] at which the falling ball comes within touch_m of the
/// ground.
std::optional<double> time_of_bounce(const Ball& ball, double horizon_s, double touch_m);

}  // namespace flinch::features
