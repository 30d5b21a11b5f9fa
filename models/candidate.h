// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

namespace flinch::models {

/// One clip that a selector considered, with what its model knows of it. A model ranks either by
/// votes or by expected costs; its candidates() says by which.
struct Candidate {
  int clip = 0;    ///< the library's index
  float vote = 0;  ///< share of the votes cast, in [0, 1]; 0 where the model casts none
  /// What playing it is expected to cost, N·s, lower is better; not a number where the model
  /// expects none.
  float expected_cost_ns = std::numeric_limits<float>::quiet_NaN();
};

/// As many candidates as there are.
inline constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

}  // namespace flinch::models
