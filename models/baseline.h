// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/selector.h"

namespace flinch::models {

/// Returns the allowed clip whose annotation is nearest to the threat: same target first, then the
/// smallest angle between its direction and the threat's azimuth (radians, from the character's
/// facing), then the lower index. This is what games commonly script by hand.
int nearest_annotation(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       float azimuth);

/// Returns the allowed clips with an annotation in this order, nearest first; the idle clip alone
/// if there are none.
std::vector<int> nearest_annotations(std::span<const ClipSummary> clips, int idle,
                                     motion::Target threatened, float azimuth);

/// Returns one of the allowed clips, including idle, with equal probability. `draw` is uniform over
/// 64 bits.
int random_allowed(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                   std::uint64_t draw);

}  // namespace flinch::models
