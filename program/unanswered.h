// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "models/selector.h"

namespace flinch::program {

/// Returns a line for each target that no clip is made for, and for each whose clips leave out
/// directions: one of the eight of annotations is left out if no clip of the target is made for it
/// or for its neighbour.
std::vector<std::string> unanswered(std::span<const models::ClipSummary> clips);

}  // namespace flinch::program
