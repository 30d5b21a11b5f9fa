// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::database {

/// What is wrong with a character, if anything is: a number that is not finite, a mass that is not
/// above 0, an unknown sex. A null pointer if nothing is.
const char* fault_of(const motion::Physique& character);

}  // namespace flinch::database
