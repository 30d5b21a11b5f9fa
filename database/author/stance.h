// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// A person at ease: feet a little apart and turned out, knees and elbows slightly bent, the centre
/// of mass above the middle of the soles, the pelvis above the origin, facing +X.
motion::Pose standing_pose(const motion::Figure& figure);

/// Standing with breath and sway, which begins and ends at rest in standing_pose, so that it can go
/// to and fro. Breath at 15 a minute; sway of the centre of mass by some millimetres with periods
/// of seconds, as in quiet standing (Winter 1995, Gait and Posture 3).
motion::Motion idle_motion(const motion::Figure& figure, float rate_hz);

}  // namespace flinch::database
