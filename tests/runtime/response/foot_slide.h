// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/response.h"

namespace flinch::tests {

/// How far a foot slides over the ground in one stand, from when it comes down until it leaves.
struct FootSlide {
  float way_m = 0;  ///< along its path
  float from_s = 0;
  float to_s = 0;
  motion::Side side = motion::Side::left;
};

/// Returns the longest slide of a response's feet between two times, s after perception. A sole
/// moves over the ground by what that of its points moves that moves least, of those on the ground:
/// a foot that rolls does not slide.
FootSlide longest_slide(const runtime::Response& response, float from_s, float to_s);

/// The same of a character that goes on in its stance.
FootSlide longest_slide(const runtime::PreparedLibrary& library,
                        const features::CharacterState& state, float to_s);

}  // namespace flinch::tests
