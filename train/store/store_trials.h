// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "train/objective/observation.h"

namespace flinch::train {

/// Trials as bytes, little-endian, one after the other by rising clip: 32 times the step from the
/// clip before (from -1 at first) plus the number of bodies that took an impulse (u16), work in J
/// (f32), and of each of these bodies its place (u8) and impulse in N s (f32).

/// Exact to the bit. Throws Error for trials whose clips do not rise or lie more than 2047 apart.
std::vector<std::byte> encode_trials(std::span<const Trial> trials);

/// Throws Error for bytes that encode_trials does not make.
std::vector<Trial> decode_trials(std::span<const std::byte> bytes);

}  // namespace flinch::train
