// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evolve/genetic/evolution.h"
#include "evolve/weakest/cell_costs.h"
#include "train/objective/vulnerability.h"

namespace flinch::evolve {

/// How to mend the cells of a library in which its own oracle leaves the most cost.
struct WeakestOptions {
  std::size_t cells = 8;
  /// Scenarios that cells are found with, and fresh ones that the gain is measured with.
  std::uint64_t scenarios = 8192;
  train::VulnerabilityProfile vulnerability = train::vulnerability_profiles()[0];
  double brawn = train::CostModel{}.brawn;
  /// Its seed is that of the scenarios too.
  GeneticOptions genetic{.population = 96, .max_generations = 20};
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;
};

/// A weak cell, and what became of it.
struct MendedCell {
  CellCost weak;     ///< as it was found
  std::string clip;  ///< that was kept; empty if none
  OracleGain gain;   ///< on the fresh scenarios, of all clips that were kept
};

struct MendedLibrary {
  std::vector<MendedCell> cells;  ///< the weakest first
  OracleGain cells_gain;          ///< on the fresh scenarios in these cells
  OracleGain whole_gain;          ///< on all fresh scenarios
};

/// Called after each generation and after each cell, with the cells that are mended in turn.
using ReportWeakest = std::function<void(const EvolutionSeries&, std::span<const CellCost> cells)>;

/// Finds the cells in which the oracle of `library` leaves the most cost on the default
/// distribution of threats, and evolves a clip for each in turn. Appends a clip and its mirror
/// image if the oracle's cost in the cell falls by at least 1 % on fresh scenarios, the clip keeps
/// all bounds of database::QualityBounds, and it does not work more than the library's clip of the
/// most work, so that costs keep their meaning. Goes on with `series`. The same options give the
/// same bits for any number of threads and interruptions. Returns nothing if `stop` became true
/// first.
std::optional<MendedLibrary> mend_weakest(const WeakestOptions& options,
                                          const ReportWeakest& report,
                                          database::ClipLibrary& library, EvolutionSeries& series);

}  // namespace flinch::evolve
