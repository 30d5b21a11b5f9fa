// SPDX-License-Identifier: MIT
#pragma once

#include "motion/collision_shape.h"

namespace flinch::sim {

/// A slower ball does not bounce, m/s.
inline constexpr double kMinBounceSpeed_mps = 0.2;

/// A contact of two things at a point for the length of a step, and its law: their velocities along
/// the normal and across it (first's less second's) after the step obey, with forces f,
///
///     v_n + softness f_n >= max(v_0, -bounce v_n before it),   f_n >= 0,
///     v_0 = error_reduction depth_m / h - free_closing_mps,
///     |f_t| <= friction f_n of a step without friction, each of two directions t by itself,
///
/// where v_0 takes an overlap back, and the bounce is left out below kMinBounceSpeed_mps.
struct ContactConstraint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< world, m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from second to first
  double depth_m = 0;
  double error_reduction = 0;
  double softness = 1e-10;  ///< m/s/N: keeps rows that mean the same apart
  double restitution = 0;
  double friction = 0;
  double free_closing_mps = 0;
};

/// The ball hits a part or the ground: a rigid bounce that gives the relative velocity along the
/// normal back `restitution` times, with Coulomb friction, and that corrects no overlap.
ContactConstraint impact_constraint(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    double restitution);
/// A part pushes another: no bounce, no friction, no correction of overlap; the two may close at
/// `free_closing_mps` unhindered.
ContactConstraint body_contact_constraint(const motion::Clearance& at, double free_closing_mps);
/// The ground carries `mass_kg` of a part at `point`, `depth_m` below it, as a critically damped
/// spring without friction.
ContactConstraint ground_constraint(const Eigen::Vector3d& point, double depth_m, double mass_kg,
                                    double step_s);

}  // namespace flinch::sim
