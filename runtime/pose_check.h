// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"

namespace flinch::runtime {

/// How far from the world's origin a character can be, along each axis, m. Floats are 8 mm apart
/// there; from ten times as far, joints would leave their limits by what is lost.
inline constexpr float kMaxPlace_m = 1e5F;

/// Whether a pose that comes from outside can be used: a place within kMaxPlace_m, rotations that
/// are unit to 1 %, which is more than what float arithmetic loses in games.
bool is_usable(const motion::Pose& pose) noexcept;

}  // namespace flinch::runtime
