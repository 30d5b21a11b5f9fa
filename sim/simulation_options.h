// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"

namespace flinch::sim {

/// Version of the simulation's laws. Raised when the same options give other impulses, so that
/// stores of different laws are not continued or merged. 2: friction is bounded along the velocity
/// of sliding; 1 bounded it along the world's axes.
inline constexpr int kLawVersion = 2;

/// How to simulate. The defaults are those of the shipped selectors; docs/simulation.md has the
/// study behind them.
struct SimulationOptions {
  double free_step_s = 1.0 / 60;       ///< step while the ball can touch nothing, s
  double contact_step_s = 1.0 / 2000;  ///< step while it can, s
  double restitution = 0.7;            ///< of ball against body and ground
  double gravity_mps2 =
      features::kGravity_mps2;  ///< of the figure, downwards; balls have their own
};

}  // namespace flinch::sim
