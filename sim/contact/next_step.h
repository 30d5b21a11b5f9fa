// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/collision/sweep.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// Surfaces no farther apart touch, m.
inline constexpr double kContactDistance_m = 1e-4;
/// Surfaces no farther apart may touch soon, m.
inline constexpr double kNearContactDistance_m = 2e-3;
/// A part driven by its motors may gain this much over the constant velocity of the sweep: a fast
/// block's hand has half of it.
inline constexpr double kMaxAcceleration_mps2 = 400;

/// What a ball's path says about the next step.
struct NextStep {
  double step_s = 0;       ///< the longest that is safe
  bool on_ground = false;  ///< the ball touches the ground, falling
};

/// The longest step for a ball among shapes: `free_step_s` while it can touch nothing, up to the
/// time at which it can; `contact_step_s` while it can; the very time of impact where that comes
/// first. Shapes that already part from it do not count.
NextStep next_step(const features::FreeFlight& ball, std::span<const MovingShape> shapes,
                   const SimulationOptions& options);

/// Whether a ball at `near` of a shape touches it and does not part from it.
bool hits(const features::FreeFlight& ball, const MovingShape& shape,
          const motion::Clearance& near);

}  // namespace flinch::sim
