// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/loop.h"

namespace flinch::database {

/// The largest gap that is closed. People's cycles differ by some centimetres and degrees; what
/// differs by more has not come round.
inline constexpr float kMaxClosedGap_m = 0.05F;
inline constexpr float kMaxClosedGap_degrees = 20;

/// A cycle that ends nearer than this to where it began, in both, stays in place.
inline constexpr float kMaxDrift_m = 0.05F;
inline constexpr float kMaxDrift_degrees = 5;

/// Returns a recorded cycle as a stance: what is left between its end and its beginning is spread
/// evenly over all poses, and the drift of one that stays in place is taken out. Throws Error for a
/// motion that does not loop, with what differs by how much; `where` is its place in a file.
motion::Motion closed_loop(const motion::Motion& motion, const std::string& where);

}  // namespace flinch::database
