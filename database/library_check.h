// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// Whether all of a pose is finite and its rotations are unit ones (to 1e-3).
bool is_sound(const motion::Pose& pose);

/// What is wrong with a character, if anything is: a number that is not finite, a mass that is not
/// above 0, an unknown sex. A null pointer if nothing is.
const char* fault_of(const motion::Character& character);

}  // namespace flinch::database
