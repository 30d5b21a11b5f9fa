// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_motion.h"

namespace flinch::database {

/// Puts feet that stand on the ground, where capture and conversion leave them a few centimetres
/// above it or under it, by turns in one take.
///
/// A foot stands while its ankle or ball moves slower than 0.2 m/s for at least 0.1 s and is within
/// 6 cm of its planted height; the lower of both then belongs at that height. The correction is
/// interpolated over the time in between and smoothed, so that steps and jumps keep their shape;
/// the hips move by the mean of both feet's. Needs set_ground.
void snap_feet_to_ground(SourceMotion& motion);

}  // namespace flinch::database
