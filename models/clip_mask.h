// SPDX-License-Identifier: MIT
#pragma once

#include <memory_resource>
#include <vector>

namespace flinch::models {

/// Whether each clip is allowed, by its index in the library.
using ClipMask = std::pmr::vector<bool>;

/// Memory resource for a selection's result and scratch space. The amount allocated depends only on
/// the model and on the allowed clips, never on the threat, so a caller that may not allocate can
/// measure it beforehand (see runtime/selection.h).
using MemoryResource = std::pmr::memory_resource*;

}  // namespace flinch::models
