// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// Returns a relaxed standing pose: feet a little apart and turned out, knees and elbows slightly
/// bent, the centre of mass above the middle of the soles, the pelvis above the origin, facing +X.
motion::Pose standing_pose(const motion::Figure& figure);

/// Returns a standing motion with breath and sway. It begins and ends at rest in standing_pose, so
/// that it can play back and forth. 15 breaths per minute; the centre of mass sways by some
/// millimetres with periods of seconds, as in quiet standing (Winter 1995, Gait and Posture 3).
motion::Motion idle_motion(const motion::Figure& figure, float rate_hz);

/// Returns a boxer's guard facing +X, left foot in front, that repeats in cycles of two seconds:
/// the pelvis turned to the right, knees bent, fists before the chin, weight shifted to and fro
/// over feet that stay.
motion::Motion guard_motion(const motion::Figure& figure, float rate_hz);

}  // namespace flinch::database
