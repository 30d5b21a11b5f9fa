// SPDX-License-Identifier: MIT
#pragma once

#include <memory_resource>
#include <vector>

namespace flinch::models {

/// Which clips are allowed, by the library's index.
using ClipMask = std::pmr::vector<bool>;

/// Where a selection takes its result and all that it needs on the way from. What it takes depends
/// on the model and on which clips are allowed alone, never on the threat, so that whoever may not
/// allocate measures it beforehand (see runtime/workspace.h).
using MemoryResource = std::pmr::memory_resource*;

}  // namespace flinch::models
