// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

namespace flinch::train {

/// A half-open interval of values, [from, to), and its name in tables.
struct Bin {
  const char* name;
  float from, to;

  constexpr bool holds(float value) const { return value >= from && value < to; }
};
inline constexpr float kUnbounded = std::numeric_limits<float>::infinity();

/// Bins of the time to impact, s.
inline constexpr std::array<Bin, 4> kTimeBins{{{"less than 0.50", 0, 0.5F},
                                               {"0.50 to 0.75", 0.5F, 0.75F},
                                               {"0.75 to 1.00", 0.75F, 1},
                                               {"1.00 or more", 1, kUnbounded}}};

}  // namespace flinch::train
