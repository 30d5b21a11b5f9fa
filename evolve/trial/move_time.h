// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::evolve {

/// The shortest motion to a pose, s.
inline constexpr double kMinMove_s = 0.25;

/// How long the eased motion between two poses takes, s: at least kMinMove_s, and so long that no
/// joint exceeds its human peak speed.
double move_time_s(const motion::Figure& figure, const motion::Pose& from, const motion::Pose& to);

}  // namespace flinch::evolve
