// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"

namespace flinch::runtime {

/// How far from the world's origin a character can be, along each axis, m. Floats are 8 mm apart
/// there; from ten times as far, joints would leave their limits by what is lost.
inline constexpr float kMaxPlace_m = 1e5F;

/// Poses that are less far apart than this say nothing about velocities, s.
inline constexpr float kMinPoseInterval_s = 1e-4F;

/// Over which the velocities of what a character shows are measured, s.
inline constexpr float kVelocityInterval_s = 1.0F / 240;

/// Whether a pose that comes from outside can be used: a place within kMaxPlace_m, rotations that
/// are unit to 1 %, which is more than what float arithmetic loses in games.
bool is_usable(const motion::Pose& pose) noexcept;

}  // namespace flinch::runtime
