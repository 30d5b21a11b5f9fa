// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/response.h"

namespace flinch::runtime {

/// Whether a response can begin like that, whatever it does then.
bool is_usable_start(const PreparedLibrary& prepared, const features::CharacterState& state,
                     float time_to_impact_s, const Inertialization& inertialization);

}  // namespace flinch::runtime
