// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"
#include "sim/body_state.h"

namespace flinch::sim {

/// Returns a rod after a step that gave it `velocity`: the point about which it turns moves
/// straight on, and the rest about that. Gravity is the caller's, as in all steps. A rod that
/// reaches the ground is over, as a stroke is at its end; a blow changes where one that is thrown
/// will reach it.
features::Ball rod_after_step(const features::Ball& rod, const Twist& velocity, double step_s,
                              bool is_struck);

}  // namespace flinch::sim
