// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "models/selector.h"
#include "runtime/workspace.h"

namespace flinch::runtime {

/// The most memory that one selection by this selector takes, bytes. Measured: the selector is
/// asked once for each target, and the need depends on nothing else. Allocates.
std::size_t selection_bytes(const models::Selector& selector);

/// Whether a selection could be made.
enum class SelectStatus : std::uint8_t {
  ok,
  too_small,  ///< the workspace was made for a selector that needs less memory
};

/// What a selector chose.
struct Selection {
  SelectStatus status = SelectStatus::too_small;
  int clip = 0;           ///< index in the library; 0 unless ok
  std::size_t count = 0;  ///< of candidates written
};

/// models::candidates() in the workspace's memory: writes the first of them to `best`, best first,
/// as many as there are or as it holds. Neither allocates nor throws.
Selection select(Workspace& workspace, const models::Selector& selector,
                 const features::FeatureVector& x, motion::Target threatened,
                 std::span<models::Candidate> best) noexcept;

}  // namespace flinch::runtime
