// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "database/annotate/take.h"

namespace flinch::tests {

/// Returns 0 until `begin_s` and 1 from `end_s` on, with the smooth course of a reaching movement
/// between them: 10 x^3 - 15 x^4 + 6 x^5 (Flash and Hogan 1985).
float minimum_jerk(double time_s, double begin_s, double end_s);

/// Returns a pulse: 0 until `begin_s`, 1 at `peak_s`, 0 from `end_s` on.
float pulse(double time_s, double begin_s, double peak_s, double end_s);

/// Returns the default character standing with its arms down.
motion::Pose standing();

/// Returns a take of this length at 60 Hz of the default character; `pose_at` gives its poses.
database::Take take_of(double duration_s, const std::function<motion::Pose(double)>& pose_at);

}  // namespace flinch::tests
