// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "train/objective/observation.h"
#include "train/store/store.h"

namespace flinch::train {

/// Whether clips are chosen for what they are made for. Shares of all choices; the idle clip is
/// made for everything.
struct IntendedUse {
  double other_target = 0;  ///< clips made for a neighbour of the threatened target
  /// Clips made for a direction 135 degrees away from the threat's, or more.
  double far_direction = 0;
  /// Both: nothing that the clip is made for speaks for it, and yet it was chosen.
  double luck = 0;
};

/// Returns the use of `chosen`, one clip per observation.
IntendedUse intended_use(const StoreHeader& header, std::span<const Observation> observations,
                         std::span<const int> chosen);

}  // namespace flinch::train
