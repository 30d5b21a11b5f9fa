// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace flinch::sim {

/// A ball in free flight, at time 0 of the motion that it meets. World frame.
struct Ball {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = 0.105;                               ///< m
  double mass_kg = 0.27;
};

/// Settings of a simulation. docs/simulation.md has the study behind the defaults.
struct SimulationOptions {
  double free_step_s = 1.0 / 60;       ///< while the ball can touch nothing
  double contact_step_s = 1.0 / 2000;  ///< while the ball can touch something
  double restitution = 0.7;            ///< of the ball with body and ground
  double gravity_mps2 = 9.81;
};

}  // namespace flinch::sim
