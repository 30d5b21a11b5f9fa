// SPDX-License-Identifier: MIT
#include "evolve/weakest/cell_costs.h"

#include <algorithm>
#include <limits>
#include <map>

namespace flinch::evolve {

double oracle_cost_ns(const train::Observation& observation, const train::CostModel& model,
                      int clip_count) {
  const auto end = std::ranges::find_if(
      observation.trials, [&](const train::Trial& trial) { return trial.clip >= clip_count; });
  const std::span trials(observation.trials.begin(), end);
  const std::vector<double> costs = costs_of(trials, observation.scenario.threat.kind, model);
  return costs[best_trial(trials, costs)];
}

std::vector<CellCost> cell_costs(std::span<const train::Observation> observations,
                                 const train::CostModel& model, int clip_count) {
  std::map<ThreatCell, CellCost> by_cell;
  for (const train::Observation& observation : observations) {
    const ThreatCell cell = cell_of(observation.scenario);
    CellCost& cost = by_cell[cell];
    cost.cell = cell;
    ++cost.scenarios;
    cost.mean_ns += oracle_cost_ns(observation, model, clip_count);
  }
  std::vector<CellCost> costs;
  for (auto& [cell, cost] : by_cell) {
    cost.mean_ns /= static_cast<double>(cost.scenarios);
    costs.push_back(cost);
  }
  return costs;
}

std::vector<CellCost> weakest_cells(std::vector<CellCost> cells, std::size_t count) {
  std::size_t scenarios = 0;
  for (const CellCost& cell : cells) scenarios += cell.scenarios;
  const std::size_t cell_count = cells.size();
  std::erase_if(cells,
                [&](const CellCost& cell) { return 4 * cell.scenarios * cell_count < scenarios; });
  std::ranges::stable_sort(cells, std::ranges::greater{}, &CellCost::mean_ns);
  if (cells.size() > count) cells.resize(count);
  return cells;
}

OracleGain oracle_gain(std::span<const train::Observation> observations,
                       const train::CostModel& model, int clip_count,
                       std::span<const ThreatCell> cells, std::uint64_t seed) {
  std::vector<double> before;
  std::vector<double> difference;
  for (const train::Observation& observation : observations) {
    if (!cells.empty() && std::ranges::find(cells, cell_of(observation.scenario)) == cells.end())
      continue;
    before.push_back(oracle_cost_ns(observation, model, clip_count));
    difference.push_back(oracle_cost_ns(observation, model, std::numeric_limits<int>::max()) -
                         before.back());
  }
  OracleGain gain;
  gain.scenarios = before.size();
  if (before.empty()) return gain;
  const train::Resamples resamples =
      train::draw_resamples(before.size(), train::kResampleCount, seed);
  const auto mean = [](double value) { return value; };
  gain.difference_ns = train::estimate(mean, train::resampled_mean(difference, resamples));
  gain.before_ns = train::resampled_mean(before, resamples).mean;
  gain.after_ns = gain.before_ns + gain.difference_ns.value;
  return gain;
}

}  // namespace flinch::evolve
