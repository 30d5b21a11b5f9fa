// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "motion/role.h"

namespace flinch::database {

/// Sizes of the float vectors in library.fbs.
inline constexpr std::size_t kFloatsPerPose = 3 + 4 * static_cast<std::size_t>(motion::kRoleCount);
inline constexpr std::size_t kFloatsPerSkeletonVector =
    3 * static_cast<std::size_t>(motion::kRoleCount);

}  // namespace flinch::database
