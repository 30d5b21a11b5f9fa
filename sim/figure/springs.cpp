// SPDX-License-Identifier: MIT
#include "sim/figure/springs.h"

#include <algorithm>
#include <cmath>

namespace flinch::sim {
namespace {

constexpr double kJointErrorTime_s = 0.02;

}  // namespace

Gains critically_damped(double inertia, double frequency) {
  return {inertia * frequency * frequency, 2 * inertia * frequency};
}

Gains scaled_gains(const Gains& gains, double share) {
  return {share * gains.stiffness, std::sqrt(share) * gains.damping};
}

AxisRow rigid_row(double error, double target_velocity, double step_s) {
  return {target_velocity + joint_error_reduction(step_s) * error / step_s, 0};
}

double joint_error_reduction(double step_s) {
  return std::min(step_s / kJointErrorTime_s, 0.8);
}

Eigen::Vector3d clamped_length(const Eigen::Vector3d& error, double max_length) {
  const double length = error.norm();
  return length > max_length ? Eigen::Vector3d(max_length / length * error) : error;
}

}  // namespace flinch::sim
