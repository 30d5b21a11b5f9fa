// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"
#include "motion/collision_shape.h"

namespace flinch::features {

/// The closest points of a ball, or rod, and an outline.
motion::Clearance clearance(const Ball& ball, const motion::CollisionShape& outline);
/// Returns only the gap `time_s` later, to the same bits.
double gap_at(const Ball& ball, double time_s, const motion::CollisionShape& outline);

}  // namespace flinch::features
