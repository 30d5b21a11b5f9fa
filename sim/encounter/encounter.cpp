// SPDX-License-Identifier: MIT
#include "sim/encounter/encounter.h"

namespace flinch::sim {

template class Encounter<TreeScene>;

}  // namespace flinch::sim
