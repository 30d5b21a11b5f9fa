// SPDX-License-Identifier: MIT
#pragma once

#include "motion/collision_shape.h"

namespace flinch::sim {

/// A ball that is slower than this does not bounce, m/s.
inline constexpr double kMinBounceSpeed_mps = 0.2;

/// A contact between two things at a point during one step, and its law. Velocities are those of
/// first less second, along the normal (n) and across it (t), after the step, and obey with forces
/// f
///
///     v_n + softness f_n >= max(v_0, -bounce v_n before it),   f_n >= 0,
///     v_0 = error_reduction depth_m / h - free_closing_mps,
///     |f_t| <= friction f_n of a step without friction, for each of two directions t separately.
///
/// v_0 corrects an overlap. Below kMinBounceSpeed_mps there is no bounce.
struct ContactConstraint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< world, m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from second to first
  double depth_m = 0;
  double error_reduction = 0;
  double softness = 1e-10;  ///< m/s/N; above 0 so that duplicate rows stay solvable
  double restitution = 0;
  double friction = 0;
  double free_closing_mps = 0;
};

/// Contact of the ball with a part or the ground: a rigid bounce that returns `restitution` times
/// the relative normal velocity, with Coulomb friction and without correction of overlap.
ContactConstraint impact_constraint(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    double restitution);
/// Contact of two parts: no bounce, no friction, no correction of overlap; the parts may close at
/// up to `free_closing_mps` without resistance.
ContactConstraint body_contact_constraint(const motion::Clearance& at, double free_closing_mps);
/// Contact of a part with the ground, which carries `mass_kg` at `point`, `depth_m` below it, as a
/// critically damped spring without friction.
ContactConstraint ground_constraint(const Eigen::Vector3d& point, double depth_m, double mass_kg,
                                    double step_s);

}  // namespace flinch::sim
