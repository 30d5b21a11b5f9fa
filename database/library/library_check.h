// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::database {

/// Returns what is wrong with a character: a bone, a stature, a breadth or a mass that is not
/// within the bounds of library_bounds.h, or an unknown sex. Returns null if nothing is wrong.
const char* fault_of(const motion::Physique& character);

}  // namespace flinch::database
