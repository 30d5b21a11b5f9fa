// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evolve/weakest/threat_cell.h"
#include "train/evaluate/bootstrap.h"
#include "train/objective/cost.h"

namespace flinch::evolve {

/// What the oracle leaves in one cell.
struct CellCost {
  ThreatCell cell;
  std::size_t scenarios = 0;
  double mean_ns = 0;  ///< cost of its best clip
};

/// Returns the cost of the best trial (train::best_trial) among the clips with a number below
/// `clip_count`.
double oracle_cost_ns(const train::Observation& observation, const train::CostModel& model,
                      int clip_count);

/// Returns the cells that observations are in, in ascending order, for an oracle with the first
/// `clip_count` clips.
std::vector<CellCost> cell_costs(std::span<const train::Observation> observations,
                                 const train::CostModel& model, int clip_count);

/// Returns the `count` cells of the largest mean cost, the largest first. Leaves out cells with
/// less than a quarter of the scenarios of a mean cell, whose mean says little.
std::vector<CellCost> weakest_cells(std::vector<CellCost> cells, std::size_t count);

/// The cost that the oracle leaves with a library, and with the same library and more clips, on the
/// same scenarios.
struct OracleGain {
  std::size_t scenarios = 0;
  double before_ns = 0;  ///< means
  double after_ns = 0;
  train::Estimate difference_ns;  ///< after less before, paired
};

/// Compares the oracle of all clips with that of the first `clip_count` on the observations in
/// `cells`, or on all if there are none. `seed` seeds the resamples of the interval.
OracleGain oracle_gain(std::span<const train::Observation> observations,
                       const train::CostModel& model, int clip_count,
                       std::span<const ThreatCell> cells, std::uint64_t seed);

}  // namespace flinch::evolve
