// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/body_set.h"
#include "sim/collision/sweep.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// Surfaces at most this far apart touch, m.
inline constexpr double kContactDistance_m = 1e-4;
/// Surfaces at most this far apart may touch soon, m.
inline constexpr double kNearContactDistance_m = 2e-3;
/// Acceleration that the motors may add to the constant velocity which the sweep assumes. The hand
/// of a fast block has half of it.
inline constexpr double kMaxAcceleration_mps2 = 400;

/// What bounces more than this leaves what it hits, and has no resting contact.
inline constexpr double kMaxRestingBounce = 0.3;

/// The shortest step that a contact may require, s.
inline constexpr double kMinStep_s = 1e-5;

/// What a ball's path implies for the next step.
struct NextStep {
  double step_s = 0;       ///< the longest safe step
  bool on_ground = false;  ///< the ball touches the ground and falls
};

/// Returns the longest step for a ball among shapes: `free_step_s` while it can touch nothing, or
/// up to the time at which it can; `contact_step_s` while it can touch something, or up to the
/// exact time of impact where that comes first. Ignores shapes that already separate from the ball.
NextStep next_step(const features::Ball& ball, std::span<const MovingShape> shapes,
                   const SimulationOptions& options);

/// How long a ball that rests on some of the shapes may be moved at once: until it may touch
/// another, at most `resting_step_s` and at least `contact_step_s`. A rod may turn by 3 degrees.
/// Returns `contact_step_s` where it does not rest: it bounces, or closes on one of the shapes that
/// it `hits` by more than kMinBounceSpeed_mps. Shapes that it touches and that separate from it
/// shorten nothing.
double resting_step(const features::Ball& ball, const motion::PerBody<MovingShape>& shapes,
                    BodySet meets, const SimulationOptions& options);

/// Whether a ball at `near` of a shape touches it and does not separate from it.
bool hits(const features::Ball& ball, const MovingShape& shape, const motion::Clearance& near);

}  // namespace flinch::sim
