// SPDX-License-Identifier: MIT
#pragma once

#include "database/annotate/timing.h"

namespace flinch::database {

/// Returns the direction that the actor faces at a movement's start: where the head points,
/// averaged over the 0.2 s around the first frame. Radians counter-clockwise from the world's X
/// axis.
float facing_at(const Trajectory& world, std::size_t frame);

/// Returns an angle in degrees, rounded to the nearest whole one.
int whole_degrees(float angle_rad);

/// What a movement protects, and from where; read off the displacements between its onset and its
/// peak. Nobody records a threat: these are guesses.
struct Protection {
  Guess<motion::Target> target;
  Guess<float> direction;  ///< that the threat comes from, radians: a multiple of pi/4, (-pi, pi]
  motion::Degree degree = motion::Degree::mild;
};

/// Guesses what a movement protects. `facing` is the actor's.
///
/// | kind | target | direction |
/// | --- | --- | --- |
/// | duck | head | front; where the head moves 0.19 m aside, from the other side |
/// | dodge | head | against the head's displacement |
/// | flinch | head; trunk where the head goes forward | against it; front where it goes forward |
/// | block | by the height of the higher wrist | front; else the side of the raised hand |
/// | step | pelvis; trunk from 0.57 m on | against the pelvis' displacement |
/// | lift | legs | front; behind where the body jumps 0.5 m forward |
/// | push | trunk | against the pelvis' displacement |
///
/// A block's wrist from 0.1 m below the head's joint on guards the head, above the navel the trunk,
/// below it the pelvis. It guards the front where the hands are thrown (kThrownHand_mps), and else
/// the side of the raised hand, away from which head and face go.
///
/// The degree is exaggerated from these sizes on, m: duck 0.4; block head moved or sunk 0.19, hand
/// 0.16 over the head, face turned by 80 degrees, or for thrown hands a step of 1.05; flinch 0.29,
/// sunk 0.21 or turned by 90 degrees; step 0.57; lift 0.97 of one foot, 0.49 of both; dodge always;
/// push 0.85 m/s, which is called strong.
Protection protection_of(const TakeSignals& signals, const MovementTimes& times,
                         const MovementMeasures& measures, MovementKind kind, float facing);

}  // namespace flinch::database
