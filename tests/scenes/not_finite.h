// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace flinch::tests {

/// Values that no reader or job may accept as a number.
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr double kNanDouble = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinityDouble = std::numeric_limits<double>::infinity();

}  // namespace flinch::tests
