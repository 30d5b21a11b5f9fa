// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "database/annotate/movement.h"

namespace flinch::database {

/// What a movement is, as a manifest's `kind` calls it.
enum class MovementKind : std::uint8_t { block, duck, dodge, step, lift, flinch, push };
std::string_view name_of(MovementKind kind);

/// How far a movement goes from its first pose, on a figure of 1.75 m.
struct MovementMeasures {
  float head_drop_m = 0;         ///< largest fall of the head joint
  float head_shift_m = 0;        ///< largest horizontal displacement of the head
  float lean_m = 0;              ///< the same of the head relative to the pelvis
  float travel_m = 0;            ///< the same of the pelvis
  float foot_rise_m = 0;         ///< largest rise of an ankle
  float both_feet_rise_m = 0;    ///< largest rise of the lower of the two ankles
  float hand_over_head_m = 0;    ///< of the highest wrist over the head joint; negative below it
  float hand_rise_m = 0;         ///< largest rise of a wrist relative to the head
  float hand_speed_mps = 0;      ///< largest speed of a wrist relative to the chest
  float centre_speed_mps = 0;    ///< largest horizontal speed of the centre of mass
  float external_speed_mps = 0;  ///< see external_speed
};

/// A hand faster than this, relative to the chest, is thrown: arms that swing along with a step
/// reach 1.8 m/s, those of someone who is hit 2.5, hands in blocks from karate 2.8 to 6.
inline constexpr float kThrownHand_mps = 2.65F;
/// Both feet this high above the ground are in a jump, m.
inline constexpr float kJumpRise_m = 0.15F;
MovementMeasures measures_of(const TakeSignals& signals, const Movement& movement);

/// Returns the speeds of both wrists relative to the chest, added, m/s; smoothed over 0.1 s.
std::vector<float> speed_of_hands(const TakeSignals& signals);

/// Returns the speed, m/s, that the centre of mass gained within half a second of a span and that
/// its feet cannot have given.
///
/// The ground pushes through a point between the feet. For a body whose angular momentum changes
/// little, that point is the zero-moment point z = c - c'' h / g, with c the centre of mass on the
/// ground, h its height and g gravity (Vukobratovic and Borovac 2004). Where z lies outside the
/// feet by a distance e, another force has accelerated the body by at least e g / h; its integral
/// is returned. Frames in which both feet are in the air are skipped.
float external_speed(const TakeSignals& signals, const FrameSpan& span);

/// Guesses the kind by these questions; the first yes decides:
///
/// | kind | the movement |
/// | --- | --- |
/// | dodge | takes the head down by 0.8 m: the body goes to the floor |
/// | lift | raises a foot by 0.45 m, as high as the other knee, or both by 0.15 m: a jump |
/// | duck | takes the head down by 0.24 m, out of a ball's way, and no hand comes above it |
/// | block | raises a wrist above the head joint by 0.05 m, or throws a hand (kThrownHand_mps) |
/// | push | carries the body 0.2 m, with a quarter of its speed from other forces than the feet's |
/// | step | carries the body 0.3 m, and 1.5 times as far as the head leans |
/// | flinch | leans the head away from above the pelvis: all the rest |
///
/// 0.24 m is half the height of a head and a volleyball's radius (0.13 + 0.11): what was aimed at
/// its middle passes over it. The confidence is that of the least certain of the answers that led
/// to the kind.
Guess<MovementKind> kind_of(const MovementMeasures& measures);

}  // namespace flinch::database
