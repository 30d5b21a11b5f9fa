// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

namespace flinch::models {

/// One clip that a selector considered, with what its model predicts for it. A model ranks
/// either by votes or by expected costs.
struct Candidate {
  int clip = 0;    ///< index in the library
  float vote = 0;  ///< share of the votes cast, in [0, 1]; 0 for a model without votes
  /// Expected cost of playing the clip, N·s; lower is better. NaN for a model that predicts no
  /// cost.
  float expected_cost_ns = std::numeric_limits<float>::quiet_NaN();
};

/// No limit on the number of candidates.
inline constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

}  // namespace flinch::models
