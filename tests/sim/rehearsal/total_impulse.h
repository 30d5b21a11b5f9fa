// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>

#include "sim/simulation_result.h"

namespace flinch::tests {

/// Returns the sum of the impulses that all bodies took, N·s.
inline double total_impulse(const sim::SimulationResult& result) {
  return std::accumulate(result.impulse.begin(), result.impulse.end(), 0.0);
}

}  // namespace flinch::tests
