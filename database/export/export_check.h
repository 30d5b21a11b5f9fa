// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// Throws Error, saying which, unless a motion can be written to a file of another tool: the
/// character is sound (see library_check.h), and the motion has a rate above 0 and at least one
/// pose, all of them sound.
void check_exportable(const motion::Physique& character, const motion::Motion& motion);

}  // namespace flinch::database
