// SPDX-License-Identifier: MIT
#pragma once

#include "motion/enum_array.h"

namespace flinch::motion {

/// What a part of a displayed figure's surface is made of.
enum class Covering : std::uint8_t { skin, hair, eyes, lips, shirt, trousers, shoes };

/// The number of coverings.
inline constexpr int kCoveringCount = 7;
/// All coverings, for range-based loops.
inline constexpr auto kCoverings = all_enumerators<Covering, kCoveringCount>();

/// One value per covering.
template <class T>
using PerCovering = EnumArray<Covering, T, kCoveringCount>;

}  // namespace flinch::motion
