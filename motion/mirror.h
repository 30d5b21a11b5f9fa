// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"

namespace flinch::motion {

/// Returns the pose mirrored in the character's X-Z plane: y changes sign, left and right exchange
/// roles. Exact: mirroring twice gives the same bits.
Pose mirrored(const Pose& pose);

/// Returns the mirrored clip: "_mirrored" is appended to its name, directions change sign (180
/// degrees stays), a push is at the other side, and `mirrored_from` is set.
Clip mirrored(const Clip& clip);

}  // namespace flinch::motion
