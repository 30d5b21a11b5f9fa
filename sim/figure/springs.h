// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace flinch::sim {

/// A spring and damper.
struct Gains {
  double stiffness = 0;  ///< N·m/rad or N/m
  double damping = 0;    ///< N·m·s/rad or N·s/m
};

/// Returns the gains with which an inertia (kg·m² or kg) is critically damped at `frequency`
/// (rad/s): k = I w^2, c = 2 I w.
Gains critically_damped(double inertia, double frequency);

/// Returns `gains` with `share` of the stiffness and sqrt(share) of the damping, so that the
/// damping stays critical. A share of 1 changes no bit.
Gains scaled_gains(const Gains& gains, double share);

/// Equation of one axis for a step: the velocity after the step plus `softness` times the axis'
/// force equals `velocity`.
struct AxisRow {
  double velocity = 0;  ///< m/s or rad/s
  double softness = 0;  ///< m/s/N or rad/s/(N·m); 0 is rigid
};

// A spring k on an error e and a damper c to a velocity w_d, both evaluated at the end of a step h:
//
//   f = k (e - h w) + c (w_d - w)   <=>   w + f / (h k + c) = (k e + c w_d) / (h k + c)
//
// This is ODE's motor row with CFM = 1 / (h k + c) and that velocity. It is stable for every h.

/// Returns the row of a spring and damper over the next step. `spring_force` is the spring's force
/// now, N or N·m.
inline AxisRow spring_row(const Gains& gains, double spring_force, double target_velocity,
                          double step_s) {
  const double stiffness = step_s * gains.stiffness + gains.damping;
  return {(spring_force + gains.damping * target_velocity) / stiffness, 1 / stiffness};
}

/// Returns the row of an axis without freedom, which corrects `error` without compliance.
AxisRow rigid_row(double error, double target_velocity, double step_s);

/// Error reduction of joints: the share of an error that a step of `step_s` corrects. Errors decay
/// over the same time (kJointErrorTime_s) for every step length.
double joint_error_reduction(double step_s);

/// Returns `error` shortened to at most `max_length`.
Eigen::Vector3d clamped_length(const Eigen::Vector3d& error, double max_length);

}  // namespace flinch::sim
