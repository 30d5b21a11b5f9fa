// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "motion/foot.h"
#include "sim/body_set.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// Strength with which the motors drive a figure to its reference, as shares of the model's
/// stiffness (see scaled_gains).
struct MotorStrength {
  double joints = 1;
  double pelvis = 1;
  double max_pelvis_force_n = std::numeric_limits<double>::infinity();
};

/// What moves a figure in a step, besides contacts. Training uses the defaults.
struct Drive {
  MotorStrength strength;
  /// If set, the state of the reference at the step's start. Forces then move the undisturbed
  /// figure exactly as its reference moves, for any stiffness, so that the springs answer
  /// disturbances only; gravity does not act, since these forces would have to balance it.
  const ReferenceState* feedforward_from = nullptr;
  /// Share of their gains with which standing feet are held in place, in place of the ground's
  /// support; 0 if they are not.
  double foot_hold = 0;
  /// The pelvis is free and the ground supports every part, not the feet alone.
  bool is_falling = false;
};

/// The body of a foot.
constexpr motion::Body foot_of(motion::Side side) {
  return side == motion::Side::left ? motion::Body::left_foot : motion::Body::right_foot;
}

/// The feet that are held in a step that ends at `target`: those that stand there, on the ground
/// and without moving.
motion::PerSide<bool> held_feet(const FigureModel& figure_model, const ReferenceState& target,
                                const Drive& drive);

/// Returns the impulse and its moment that change a body's momentum and angular momentum as the
/// reference does from `from` to `to`, N·s and N·m·s.
Twist feedforward_impulse(const FigureModel& figure_model, motion::Body body, const BodyState& from,
                          const BodyState& to);

}  // namespace flinch::sim
