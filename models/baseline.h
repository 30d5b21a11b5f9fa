// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "models/selector.h"

namespace flinch::models {

/// The allowed clip whose annotation is nearest to the threat: the same target first, then the
/// smallest angle between its direction and the threat's azimuth (radians, from the character's
/// facing), then the lower index. What a game does by hand today.
int nearest_annotation(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       float azimuth);

/// Any allowed clip, idle among them, with equal chance: `draw` is uniform over 64 bits.
int random_allowed(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                   std::uint64_t draw);

}  // namespace flinch::models
