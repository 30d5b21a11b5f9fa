// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// Throws Error, with the reason, unless a motion can be exported: the character is sound (see
/// library_check.h), the rate is above 0, and there is at least one pose, all of them sound.
void check_exportable(const motion::Physique& character, const motion::Motion& motion);

}  // namespace flinch::database
