// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::database {

/// Returns what is wrong with a character: a number that is not finite, a mass that is not above 0,
/// or an unknown sex. Returns null if nothing is wrong.
const char* fault_of(const motion::Physique& character);

}  // namespace flinch::database
