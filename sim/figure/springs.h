// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace flinch::sim {

/// A spring and damper.
struct Gains {
  double stiffness = 0;  ///< N·m/rad or N/m
  double damping = 0;    ///< N·m·s/rad or N·s/m
};

/// Of an inertia (kg·m² or kg) that swings at `frequency` (rad/s): k = I w^2, c = 2 I w.
Gains critically_damped(double inertia, double frequency);

/// With `share` of the stiffness and, so that the damping stays critical, its root of the damping.
/// A share of 1 changes no bit.
Gains scaled_gains(const Gains& gains, double share);

/// What a step asks of one axis: that its velocity after the step, plus `softness` times the force
/// that it takes, be `velocity`.
struct AxisRow {
  double velocity = 0;  ///< m/s or rad/s
  double softness = 0;  ///< m/s/N or rad/s/(N·m); 0 is rigid
};

// A spring k to an error e and a damper c to a velocity w_d, both taken at the end of a step h:
//
//   f = k (e - h w) + c (w_d - w)   <=>   w + f / (h k + c) = (k e + c w_d) / (h k + c)
//
// which is ODE's motor row with CFM = 1 / (h k + c) and that velocity. It is stable for every h.

/// A spring and damper over the next step: `spring_force` is the spring's force now, N or N·m.
inline AxisRow spring_row(const Gains& gains, double spring_force, double target_velocity,
                          double step_s) {
  const double stiffness = step_s * gains.stiffness + gains.damping;
  return {(spring_force + gains.damping * target_velocity) / stiffness, 1 / stiffness};
}

/// An axis without freedom: it takes `error` back with no give.
AxisRow rigid_row(double error, double target_velocity, double step_s);

/// Error reduction of joints, as the share of an error that a step of `step_s` takes back, so that
/// errors fade over the same time (kJointErrorTime_s) whatever the step is.
double joint_error_reduction(double step_s);

/// `error`, no longer than `max_length`.
Eigen::Vector3d clamped_length(const Eigen::Vector3d& error, double max_length);

}  // namespace flinch::sim
