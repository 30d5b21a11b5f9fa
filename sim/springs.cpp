// SPDX-License-Identifier: MIT
#include "sim/springs.h"

#include <algorithm>
#include <cmath>

namespace flinch::sim {
namespace {

constexpr double kJointErrorTime_s = 0.02;

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
AxisRow spring_row(const Gains& gains, double pull, double wanted_velocity, double step_s) {
  const double stiffness = step_s * gains.stiffness + gains.damping;
  return {(pull + gains.damping * wanted_velocity) / stiffness, 1 / stiffness};
}

AxisRow rigid_row(double error, double wanted_velocity, double step_s) {
  return {wanted_velocity + joint_error_reduction(step_s) * error / step_s, 0};
}

double joint_error_reduction(double step_s) {
  return std::min(step_s / kJointErrorTime_s, 0.8);
}

Eigen::Vector3d shortened(const Eigen::Vector3d& error, double most) {
  const double length = error.norm();
  return length > most ? Eigen::Vector3d(most / length * error) : error;
}

}  // namespace flinch::sim
