// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// Returns a motion as BVH text.
///
/// BVH declares neither units nor axes. This uses what most files have and most tools assume:
/// centimetres, Y up, the character facing Z, X to its left; our (x, y, z) becomes (y, z, x).
/// Joints are named after their roles (see motion/role.h). The OFFSETs define the T-pose; heads,
/// hands and toes end in an End Site. The pelvis has its world position as channels and no OFFSET,
/// so that readers that add the two and readers that replace one by the other agree. Rotation
/// channels are Z X Y, in degrees, and continuous from frame to frame, beyond 180 where necessary.
///
/// Numbers have six decimals: reading the text back gives the motion to 0.001 degrees and 0.01 mm.
/// The same input gives the same text. Throws Error when the motion cannot be written (see
/// export_check.h).
std::string bvh_text(const motion::Physique& character, const motion::Motion& motion);

/// Text near the start of every file that write_bvh makes and of few others.
inline constexpr std::string_view kBvhMark =
    "ROOT pelvis\n{\n\tOFFSET 0.000000 0.000000 0.000000\n";

/// Writes the text to a file atomically. Throws Error.
void write_bvh(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion);

}  // namespace flinch::database
