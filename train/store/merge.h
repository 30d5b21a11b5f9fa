// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "database/files/output_check.h"

namespace flinch::train {

/// Merges stores of one run into one store of all their scenarios. Its bytes equal those of a store
/// that was simulated in one go. Memory does not grow with the stores. If interrupted, merge again
/// to continue. Throws Error, naming the file, for a store that is unfinished, is of another
/// library, seed, distribution or simulation than the first, or holds other observations of a
/// scenario than another store does, and for a gap between the scenarios of two stores.
/// Throws Error too for a file at `out` that is no store, unless `overwrite` says to replace it.
void merge_stores(std::span<const std::string> paths, const std::string& out,
                  database::Overwrite overwrite = database::Overwrite::refuse);

}  // namespace flinch::train
