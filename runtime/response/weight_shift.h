// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "runtime/response/response.h"

namespace flinch::runtime {

/// Plans shift `number` of the response: over the foot `over`, from `begin_s` on, before the other
/// leaves the ground at `lift_s`. It has ended by `latest_s`. Times are in s after perception.
void shift_weight(Response& response, std::size_t number, motion::Side over, float lift_s,
                  float begin_s, float latest_s);

}  // namespace flinch::runtime
