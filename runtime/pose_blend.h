// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"
#include "runtime/character.h"

namespace flinch::runtime {

/// The game's pose `game` with Flinch's pose `ours` laid over it by the mask, as
/// Character::pose_over does.
motion::Pose blended(const motion::Pose& game, const motion::Pose& ours, const Mask& mask) noexcept;

}  // namespace flinch::runtime
