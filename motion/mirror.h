// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "motion/clip.h"

namespace flinch::motion {

/// Returns the pose mirrored in the character's X-Z plane: y changes sign, left and right exchange
/// roles. Exact: mirroring twice gives the same bits.
Pose mirrored(const Pose& pose);

/// Makes `images` the mirror images of `poses`, at a third of the time of one by one.
void mirror(std::span<const Pose> poses, std::vector<Pose>& images);

/// Returns the mirrored clip: "_mirrored" is appended to its name, directions change sign (180
/// degrees stays), a push is at the other side, and `mirrored_from` is set.
Clip mirrored(const Clip& clip);

}  // namespace flinch::motion
