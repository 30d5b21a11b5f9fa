// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure/springs.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// Sets a parameter of a linear or an angular motor: dJointSetLMotorParam or dJointSetAMotorParam.
using SetMotorParameter = void (*)(dJointID, int, dReal);

/// Sets a motor's axis to `row` for the next step.
void set_row(dJointID motor, int axis, const AxisRow& row, SetMotorParameter set);

/// Sets a motor's axis to a spring and damper for the next step; see spring_row.
void set_spring(dJointID motor, int axis, const Gains& gains, double spring_force,
                double target_velocity, double step_s, SetMotorParameter set);

/// Sets the three axes of an angular motor, columns; they turn with `second` where there is one.
void set_axes(dJointID motor, dBodyID second, const Eigen::Matrix3d& axes_world);

/// Creates a motor about three axes. Its force is unbounded, which keeps its rows out of the
/// solver's pivoting.
dJointID make_motor(dWorldID world, dBodyID first, dBodyID second,
                    const Eigen::Matrix3d& axes_world);

/// Creates an unbounded motor along the world's axes.
dJointID make_linear_motor(dWorldID world, dBodyID body);

}  // namespace flinch::sim
