// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"

namespace flinch::runtime {

/// Whether a pose that comes from outside can be used: a place within features::kMaxExtent of the
/// origin, rotations that are unit to 1 %, which is more than what float arithmetic loses in games.
bool is_usable(const motion::Pose& pose) noexcept;

}  // namespace flinch::runtime
