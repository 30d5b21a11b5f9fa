// SPDX-License-Identifier: MIT
#include "sim/ode/motors.h"

namespace flinch::sim {

// ODE numbers the parameters of a motor's axes in groups.
void set_row(dJointID motor, int axis, const AxisRow& row, SetMotorParameter set) {
  set(motor, dParamVel + axis * dParamGroup, row.velocity);
  set(motor, dParamCFM + axis * dParamGroup, row.softness);
}

void set_spring(dJointID motor, int axis, const Gains& gains, double spring_force,
                double target_velocity, double step_s, SetMotorParameter set) {
  set_row(motor, axis, spring_row(gains, spring_force, target_velocity, step_s), set);
}

void set_axes(dJointID motor, dBodyID second, const Eigen::Matrix3d& axes_world) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = axes_world.col(axis);
    dJointSetAMotorAxis(motor, axis, second ? 2 : 0, direction.x(), direction.y(), direction.z());
  }
}

dJointID make_motor(dWorldID world, dBodyID first, dBodyID second,
                    const Eigen::Matrix3d& axes_world) {
  const dJointID motor = dJointCreateAMotor(world, nullptr);
  dJointAttach(motor, first, second);
  dJointSetAMotorNumAxes(motor, 3);
  set_axes(motor, second, axes_world);
  for (int axis = 0; axis < 3; ++axis) {
    dJointSetAMotorParam(motor, dParamFMax + axis * dParamGroup, dInfinity);
  }
  return motor;
}

dJointID make_linear_motor(dWorldID world, dBodyID body) {
  const dJointID motor = dJointCreateLMotor(world, nullptr);
  dJointAttach(motor, body, nullptr);
  dJointSetLMotorNumAxes(motor, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = Eigen::Vector3d::Unit(axis);
    dJointSetLMotorAxis(motor, axis, 0, direction.x(), direction.y(), direction.z());
    dJointSetLMotorParam(motor, dParamFMax + axis * dParamGroup, dInfinity);
  }
  return motor;
}

}  // namespace flinch::sim
