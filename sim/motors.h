// SPDX-License-Identifier: MIT
#pragma once

#include "sim/ode_world.h"

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
Gains weakened(const Gains& gains, double share);

/// Sets a parameter of a linear or an angular motor: dJointSetLMotorParam or dJointSetAMotorParam.
using SetMotorParameter = void (*)(dJointID, int, dReal);

/// Makes an axis of a motor a spring and damper for the next step: `pull` is the spring's force
/// now, N or N·m; see motors.cpp.
void set_spring(dJointID motor, int axis, const Gains& gains, double pull, double wanted_velocity,
                double step_s, SetMotorParameter set);

/// Makes an axis of an angular motor one without freedom: it takes `error` back with no give.
void set_rigid(dJointID motor, int axis, double error, double wanted_velocity, double step_s);

/// The three axes of an angular motor, columns; they turn with `second` where there is one.
void set_axes(dJointID motor, dBodyID second, const Eigen::Matrix3d& axes_world);

/// A motor about three axes. Its force knows no bound, which keeps its rows out of the solver's
/// pivoting.
dJointID make_motor(dWorldID world, dBodyID first, dBodyID second,
                    const Eigen::Matrix3d& axes_world);

/// A motor along the world's axes, without bound.
dJointID make_linear_motor(dWorldID world, dBodyID body);

/// `error`, no longer than `most`.
Eigen::Vector3d shortened(const Eigen::Vector3d& error, double most);

}  // namespace flinch::sim
