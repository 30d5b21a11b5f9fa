// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::sim {

/// Where a body is and how it moves: its centre of mass, world.
struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< rad/s
};

}  // namespace flinch::sim
