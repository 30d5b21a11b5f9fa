// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/response.h"

namespace flinch::runtime {

/// Sets how long the response blends into its clip: until the velocities of its joints change
/// least.
void choose_blend_duration(Response& response);

}  // namespace flinch::runtime
