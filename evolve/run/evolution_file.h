// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evolve/genetic/evolution.h"

namespace flinch::evolve {

/// The first bytes of every file that keeps a run, and of no others.
inline constexpr std::string_view kEvolutionMark = "{\"kind\":\"evolution\",";

/// Writes runs atomically, as JSON. `key` names everything that they depend on. Throws Error.
void write_evolution(const std::string& path, const std::string& key,
                     const EvolutionSeries& series);

/// Reads runs; nothing if there is no file. Throws Error if the file holds no runs, is damaged, has
/// another key, more than about 100,000 generations, or chromosomes of other numbers than these.
/// Between two runs there are none.
std::optional<EvolutionSeries> read_evolution(const std::string& path, const std::string& key,
                                              std::size_t population, std::size_t gene_count);

}  // namespace flinch::evolve
