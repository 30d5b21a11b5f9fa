// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::sim {

/// Pose and velocity of a rigid body at its centre of mass. World frame.
struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< rad/s
};

}  // namespace flinch::sim
