// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure/springs.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// Sets a parameter of a linear or an angular motor: dJointSetLMotorParam or dJointSetAMotorParam.
using SetMotorParameter = void (*)(dJointID, int, dReal);

/// Makes an axis of a motor this for the next step.
void set_row(dJointID motor, int axis, const AxisRow& row, SetMotorParameter set);

/// Makes an axis of a motor a spring and damper for the next step; see spring_row.
void set_spring(dJointID motor, int axis, const Gains& gains, double spring_force,
                double target_velocity, double step_s, SetMotorParameter set);

/// The three axes of an angular motor, columns; they turn with `second` where there is one.
void set_axes(dJointID motor, dBodyID second, const Eigen::Matrix3d& axes_world);

/// A motor about three axes. Its force knows no bound, which keeps its rows out of the solver's
/// pivoting.
dJointID make_motor(dWorldID world, dBodyID first, dBodyID second,
                    const Eigen::Matrix3d& axes_world);

/// A motor along the world's axes, without bound.
dJointID make_linear_motor(dWorldID world, dBodyID body);

}  // namespace flinch::sim
