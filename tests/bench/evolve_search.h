// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::evolve {

class PoseTrial;

/// Prints how many evaluations mutation schemes, populations, tournaments and CMA-ES take to within
/// 5 % of the best fitness that any of them finds with `budget` evaluations, from seeds 1 to
/// `seeds`; a table after each seed. All meet the balls of one draw, so that fitness is a function
/// of the pose.
void print_search(const PoseTrial& trial, std::size_t budget, std::size_t seeds, int threads);

}  // namespace flinch::evolve
