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

/// What makes a ball a rod: its centre, drawn out along an axis, that turns about a point of it. A
/// rod of no length is a ball. Where another is held, hands and rod are one body.
struct RodShape {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit, from butt to tip
  /// From Ball::position to the centres of the rounded ends, along the axis, m; both 0 for a ball.
  double to_butt_m = 0;
  double to_tip_m = 0;
  double to_pivot_m = 0;    ///< the same to the point about which it turns, towards the butt
  double inertia_kgm2 = 0;  ///< about an axis across it through Ball::position
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, across the axis
};

/// A ball as physics moves it, and its free flight: x(t) = x + v t - g t^2 / 2 z. Of a rod, that is
/// the flight of the point about which it turns, at a constant rate. World frame, Z up.
struct Ball {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre of mass, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = kVolleyballRadius_m;                 ///< m
  double mass_kg = kVolleyballMass_kg;
  double gravity_mps2 = kGravity_mps2;  ///< downwards; 0 for a ball that flies straight
  Bounce bounce{};
  TouchWindow window{};
  RodShape rod{};

  bool is_rod() const { return rod.to_butt_m + rod.to_tip_m > 0; }
  /// The position `time_s` later: x + v t - g t^2 / 2 z.
  Eigen::Vector3d position_at(double time_s) const;
  /// The velocity then: v - g t z.
  Eigen::Vector3d velocity_at(double time_s) const;
  /// The ball `time_s` later: its position and velocity then.
  Ball at(double time_s) const;

  /// Velocity of its material point that is at `point`, m/s; without the spin of a ball.
  Eigen::Vector3d velocity_of(const Eigen::Vector3d& point) const;
  /// Velocity of the point about which it turns, m/s: of a ball, its own.
  Eigen::Vector3d pivot_velocity() const;
  /// The largest speed that turning gives to a point of its axis, m/s; 0 for a ball.
  double turning_mps() const;
  /// Radius of the sphere about its position that contains it, m.
  double bounding_radius() const;
};

/// The ball that a threat is, with its current position and velocity. `gravity_mps2` is that of one
/// that falls. A stroke is a ball that flies along its line all the time, but touches only during
/// the stroke; one that waits is then farther back on the line than where it waits. A rod touches
/// nothing after it has reached the ground.
Ball ball_of(const Threat& threat, double gravity_mps2 = kGravity_mps2);

/// The moment of inertia of a ball about any axis, kg m^2, as a thin spherical shell: 2/3 m r^2.
double moment_of_inertia(const Ball& ball);

/// Velocities that an impulse and its moment about the position, world, give a ball or rod at rest.
struct VelocityChange {
  Eigen::Vector3d linear;
  Eigen::Vector3d angular;
};
/// Returns them for a ball of this moment of inertia. A rod has its own, and does not roll.
VelocityChange velocity_change(const Ball& ball, double inertia_kgm2,
                               const Eigen::Vector3d& impulse, const Eigen::Vector3d& moment);

/// Height of the lowest point of the ball, or rod, m.
double lowest_point_m(const Ball& ball);

/// Returns the first time in [0, horizon_s] at which the falling ball comes within touch_m of the
/// ground. A rod does not bounce: see ball_of.
std::optional<double> time_of_bounce(const Ball& ball, double horizon_s, double touch_m);

}  // namespace flinch::features
