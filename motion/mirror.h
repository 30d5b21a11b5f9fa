// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"

namespace flinch::motion {

/// The pose seen in a mirror in the character's X-Z plane: y changes sign, left and right change
/// roles. Exact: mirroring twice gives the same bits.
Pose mirrored(const Pose& pose);

/// The mirrored clip, with its name suffixed "_mirrored", its direction's sign changed (180 degrees
/// stays) and `mirrored_from` set.
Clip mirrored(const Clip& clip);

}  // namespace flinch::motion
