// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace flinch::train {

/// Joins stores of one run into one of all their scenarios, which has the bytes of a store that was
/// simulated at once. Memory does not grow with the stores. Interrupted, it is gone on with by
/// merging again. Throws Error, naming the file, for a store that is not finished, is of another
/// library, seed, distribution or simulation than the first, or holds other observations of a
/// scenario than another does, and for scenarios between two stores that none holds.
void merge_stores(std::span<const std::string> paths, const std::string& out);

}  // namespace flinch::train
