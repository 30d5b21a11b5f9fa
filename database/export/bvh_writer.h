// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// A motion as BVH text.
///
/// BVH says neither its units nor its axes. These are the ones that most files have and most tools
/// take for granted: centimetres, Y up, the character facing Z, X to its left; from ours, (x, y, z)
/// becomes (y, z, x). Joints are named after their roles (see motion/role.h); the OFFSETs draw the
/// T-pose; heads, hands and toes end in an End Site. The pelvis has its position in the world as
/// channels and no OFFSET, so that readers that add the two and readers that replace agree.
/// Rotation channels are Z X Y, in degrees, and run on from frame to frame, beyond 180 where they
/// must.
///
/// Numbers have six decimals: what is read back is the motion to 0.001 degrees and 0.01 mm. The
/// same input gives the same text. Throws Error when the motion cannot be written (see
/// export_check.h).
std::string bvh_text(const motion::Physique& character, const motion::Motion& motion);

/// Writes it to a file, whole or not at all. Throws Error.
void write_bvh(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion);

}  // namespace flinch::database
