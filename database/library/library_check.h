// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/library/library_file.h"
#include "motion/body.h"

namespace flinch::database {

/// Returns what is wrong with a character: a bone, a stature, a breadth or a mass that is not
/// within the bounds of library_bounds.h, or an unknown sex. Returns null if nothing is wrong.
const char* fault_of(const motion::Physique& character);

/// The fault_of() a library whose poses unpack_poses() has found sound, or are mirror images of
/// such: looks at everything else.
std::optional<LibraryFault> fault_beside_poses(const ClipLibrary& library);

}  // namespace flinch::database
