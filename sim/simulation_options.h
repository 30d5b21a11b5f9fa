// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"

namespace flinch::sim {

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
