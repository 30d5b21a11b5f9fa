// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// How long after a hit limits are measured, and in steps of at most this length, s.
inline constexpr double kFollowThrough_s = 0.1;
inline constexpr double kFollowStep_s = 0.005;

/// How far the joints of a figure are beyond their limits, summed over joints, rad. What the
/// reference itself exceeds is allowed. Fixed joints have no limits.
double limit_excess_rad(const FigureModel& figure_model, const motion::PerBody<BodyState>& figure,
                        const ReferenceState& reference);

}  // namespace flinch::sim
