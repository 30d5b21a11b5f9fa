// SPDX-License-Identifier: MIT
#pragma once

#include "sim/collision/sweep.h"

namespace flinch::sim {

/// How near two parts are: spheres that fill either against the exact other; where each is nearest.
/// The normal points from `second` to `first`.
motion::Clearance clearance(const MovingShape& first, const MovingShape& second);

}  // namespace flinch::sim
