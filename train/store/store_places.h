// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "train/objective/observation.h"

namespace flinch::train {

/// Encoding of places as bytes, little-endian, one after the other in ascending order of clips.
/// Each is the clip's index (u16), the body's (u8), the impulse in N s (f32) and the point in the
/// frame of the body's joint, x, y and z in mm (i16 each).
inline constexpr std::size_t kPlaceBytes = 13;

/// Encodes places exactly. Throws Error unless their clips ascend and are below 65536.
std::vector<std::byte> encode_places(std::span<const HitPlace> places);

/// Decodes places. Throws Error for bytes that encode_places does not produce.
std::vector<HitPlace> decode_places(std::span<const std::byte> bytes);

}  // namespace flinch::train
