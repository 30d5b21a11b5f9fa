// SPDX-License-Identifier: MIT
#include "sim/tree/factor_trees.h"
#include "sim/tree/move_figures.h"

namespace flinch::sim {

template <>
void factor_trees(const TreeConstants& constants, TreeLanes<8>& lanes) {
  factor_lanes(constants, lanes);
}
template <>
void move_figures(const TreeConstants& constants, TreeLanes<8>& lanes) {
  move_lanes(constants, lanes);
}

}  // namespace flinch::sim
