// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_motion.h"

namespace flinch::database {

/// Puts the ground at 0: below the point of the feet that is lowest while they stand flat. Sets
/// ankle_height_m and ball_height_m, of each foot on its own: markers and bone lengths are a
/// centimetre off as often as not. Lying feet and single glitches do not count.
void set_ground(SourceMotion& motion);

/// Turns each foot, by a constant in its own frame, so that it is flat on the ground while its
/// ankle is lowest. Rest figures and motion disagree about that by up to some 15 degrees; a larger
/// angle is left alone as a foot that never stood flat. Needs the ground.
void level_feet(SourceMotion& motion);

/// Turns each upper arm and thigh, by a constant about its own bone, so that elbow and knee bend
/// about their hinge (see motion::hinge_axis). A reference pose does not show how a straight limb
/// will bend; the motion does. Legs that bend too little to tell take the direction of the foot,
/// arms are left alone. Needs level feet.
void align_hinges(SourceMotion& motion);

}  // namespace flinch::database
