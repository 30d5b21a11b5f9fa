// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::evolve {

class PoseTrial;

/// Compares mutation schemes, populations, tournaments and CMA-ES on the balls of one draw, so that
/// fitness is a function of the pose. Each search ends with the generation in which it has tested
/// `budget` poses; those that are kept unchanged are not tested again. Prints a table after each of
/// the seeds 1 to `seeds`. `full_turn` is the same trial with the thesis' map of genes.
void print_search(const PoseTrial& limits, const PoseTrial& full_turn, std::size_t budget,
                  std::size_t seeds, int threads);

}  // namespace flinch::evolve
