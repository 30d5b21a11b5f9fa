// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_motion.h"

namespace flinch::database {

/// Moves standing feet onto the ground. Capture and conversion leave them up to a few centimetres
/// above or below it, varying within one take.
///
/// A foot stands while its ankle or ball moves slower than 0.2 m/s for at least 0.1 s and is within
/// 6 cm of its planted height; the lower of the two is then moved to that height. In between, the
/// correction is interpolated, then smoothed, so that steps and jumps keep their shape. The hips
/// move by the mean correction of both feet. Call set_ground first.
void snap_feet_to_ground(SourceMotion& motion);

}  // namespace flinch::database
