// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "features/threat.h"

namespace flinch::features {

/// The time in which a ball can touch anything, s from now: always, except for a stroke.
struct TouchWindow {
  double from_s = -std::numeric_limits<double>::infinity();
  double until_s = std::numeric_limits<double>::infinity();

  bool is_open() const { return from_s <= 0 && until_s >= 0; }
  bool is_over() const { return until_s < 0; }
  /// Whether it is open at some time in [0, horizon_s].
  bool opens_within(double horizon_s) const { return from_s <= horizon_s && until_s >= 0; }
  /// The window as it is `time_s` later.
  TouchWindow at(double time_s) const { return {from_s - time_s, until_s - time_s}; }
};

/// A ball as physics moves it, and its free flight: x(t) = x + v t - g t^2 / 2 z. World frame, Z
/// up.
struct Ball {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = kVolleyballRadius_m;                 ///< m
  double mass_kg = kVolleyballMass_kg;
  double gravity_mps2 = kGravity_mps2;  ///< downwards; 0 for a ball that flies straight
  Bounce bounce{};
  TouchWindow window{};

  /// The position `time_s` later: x + v t - g t^2 / 2 z.
  Eigen::Vector3d position_at(double time_s) const;
  /// The velocity then: v - g t z.
  Eigen::Vector3d velocity_at(double time_s) const;
  /// The ball `time_s` later: its position and velocity then.
  Ball at(double time_s) const;
};

/// The ball that a threat is, with its current position and velocity. `gravity_mps2` is that of one
/// that falls. A stroke is a ball that flies along its line all the time, but touches only during
/// the stroke; one that waits is then farther back on the line than where it waits.
Ball ball_of(const Threat& threat, double gravity_mps2 = kGravity_mps2);

/// The moment of inertia of a ball about any axis, kg m^2, as a thin spherical shell: 2/3 m r^2.
double moment_of_inertia(const Ball& ball);

/// Returns the first time in [0, horizon_s] at which the falling ball comes within touch_m of the
/// ground.
std::optional<double> time_of_bounce(const Ball& ball, double horizon_s, double touch_m);

}  // namespace flinch::features
