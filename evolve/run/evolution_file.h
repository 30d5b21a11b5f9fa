// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evolve/genetic/evolution.h"

namespace flinch::evolve {

/// The first bytes of every file that keeps a run, and of no others.
inline constexpr std::string_view kEvolutionMark = "{\"kind\":\"evolution\",";

/// Writes a run atomically, as JSON. `key` names everything that the run depends on. Throws Error.
void write_evolution(const std::string& path, const std::string& key, const Evolution& evolution);

/// Reads a run; nothing if there is no file. Throws Error if the file is no run, is damaged, has
/// another key, or holds chromosomes of other numbers than these.
std::optional<Evolution> read_evolution(const std::string& path, const std::string& key,
                                        std::size_t population, std::size_t gene_count);

}  // namespace flinch::evolve
