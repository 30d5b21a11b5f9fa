// SPDX-License-Identifier: MIT
#pragma once

#include "sim/collision/sweep.h"

namespace flinch::sim {

/// Smallest gap between two parts and where each is nearest to the other. Each part in turn is
/// approximated by spheres inside it and tested against the exact shape of the other. The normal
/// points from `second` to `first`.
motion::Clearance clearance(const MovingShape& first, const MovingShape& second);

}  // namespace flinch::sim
