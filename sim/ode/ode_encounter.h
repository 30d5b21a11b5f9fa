// SPDX-License-Identifier: MIT
#pragma once

#include "sim/encounter/encounter.h"
#include "sim/ode/ode_scene.h"

namespace flinch::sim {

extern template class Encounter<OdeScene>;

}  // namespace flinch::sim
