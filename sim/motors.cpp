// SPDX-License-Identifier: MIT
#include "sim/motors.h"

#include <cmath>

namespace flinch::sim {
namespace {

/// Parameters of one axis of a motor: ODE numbers them in groups.
void set_axis(dJointID motor, int axis, double velocity, double softness, SetMotorParameter set) {
  set(motor, dParamVel + axis * dParamGroup, velocity);
  set(motor, dParamCFM + axis * dParamGroup, softness);
}

}  // namespace

Gains critically_damped(double inertia, double frequency) {
  return {inertia * frequency * frequency, 2 * inertia * frequency};
}

Gains weakened(const Gains& gains, double share) {
  return {share * gains.stiffness, std::sqrt(share) * gains.damping};
}

// A spring k to an error e and a damper c to a velocity w_d, both taken at the end of a step h:
//
//   f = k (e - h w) + c (w_d - w)   <=>   w + f / (h k + c) = (k e + c w_d) / (h k + c)
//
// which is ODE's motor row with CFM = 1 / (h k + c) and that velocity. It is stable for every h.
void set_spring(dJointID motor, int axis, const Gains& gains, double pull, double wanted_velocity,
                double step_s, SetMotorParameter set) {
  const double stiffness = step_s * gains.stiffness + gains.damping;
  set_axis(motor, axis, (pull + gains.damping * wanted_velocity) / stiffness, 1 / stiffness, set);
}

void set_rigid(dJointID motor, int axis, double error, double wanted_velocity, double step_s) {
  const double velocity = wanted_velocity + joint_error_reduction(step_s) * error / step_s;
  set_axis(motor, axis, velocity, 0, dJointSetAMotorParam);
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

Eigen::Vector3d shortened(const Eigen::Vector3d& error, double most) {
  const double length = error.norm();
  return length > most ? Eigen::Vector3d(most / length * error) : error;
}

}  // namespace flinch::sim
