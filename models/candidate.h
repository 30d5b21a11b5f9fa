// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::models {

/// One clip that a selector considered, with how strongly it is for it.
struct Candidate {
  int clip = 0;    ///< the library's index
  float vote = 0;  ///< share of the votes cast, in [0, 1]
};

}  // namespace flinch::models
