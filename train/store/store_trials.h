// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "train/objective/observation.h"

namespace flinch::train {

/// Encoding of trials as bytes, little-endian, one after the other in ascending order of clips.
/// Each is 32 times the difference to the clip before (-1 before the first) plus the number of
/// bodies with an impulse (u16), the work in J (f32), and for each of these bodies its index (u8)
/// and impulse in N s (f32).

/// The most bytes that one trial takes: of a clip whose every body took an impulse.
inline constexpr std::size_t kMaxTrialBytes = 6 + 5 * motion::kBodyCount;

/// Encodes trials exactly. Throws Error unless their clips ascend by at most 2047.
std::vector<std::byte> encode_trials(std::span<const Trial> trials);

/// Decodes trials. Throws Error for bytes that encode_trials does not produce.
std::vector<Trial> decode_trials(std::span<const std::byte> bytes);

}  // namespace flinch::train
