// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_motion.h"

namespace flinch::database {

/// Sets the ground to height 0: it is below the lowest point of the feet while they are flat. Also
/// sets ankle_height_m and ball_height_m, separately for each foot, because errors of a centimetre
/// in markers and bone lengths are common. Feet that are not flat and single-frame glitches are
/// ignored.
void set_ground(SourceMotion& motion);

/// Rotates each foot by a constant in its own frame, so that it is flat on the ground while its
/// ankle is lowest. Rest figures and motion differ by up to about 15 degrees in this; a larger
/// angle means that the foot never stood flat, and is left as it is. Call set_ground first.
void level_feet(SourceMotion& motion);

/// Rotates each upper arm and thigh by a constant about its own bone, so that elbow and knee bend
/// about their hinges (see motion::hinge_axis). A reference pose does not show how a straight limb
/// will bend; the motion does. Legs that bend too little use the direction of the foot; such arms
/// are left as they are. Call level_feet first.
void align_hinges(SourceMotion& motion);

}  // namespace flinch::database
