// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace flinch::sim {

/// A ball in free flight, when the motion that it meets begins or when a reaction does. World
/// frame, Z up.
struct Ball {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = 0.105;                               ///< m
  double mass_kg = 0.27;                               ///< a volleyball's by default
};

/// How to simulate. The defaults are those of the shipped selectors; docs/simulation.md has the
/// study behind them.
struct SimulationOptions {
  double free_step_s = 1.0 / 60;       ///< step while the ball can touch nothing, s
  double contact_step_s = 1.0 / 2000;  ///< step while it can, s
  double restitution = 0.7;            ///< of ball against body and ground
  double gravity_mps2 = 9.81;          ///< downwards
};

}  // namespace flinch::sim
