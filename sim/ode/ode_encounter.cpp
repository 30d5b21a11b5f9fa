// SPDX-License-Identifier: MIT
#include "sim/ode/ode_encounter.h"

namespace flinch::sim {

template class Encounter<OdeScene>;

}  // namespace flinch::sim
