// SPDX-License-Identifier: MIT
#include "train/evaluate/directions.h"

#include <cmath>
#include <numbers>

namespace flinch::train {
namespace {

constexpr int kSectorDegrees = 360 / kDirectionSectors;

/// The middle of the sector that a scenario's threat comes from, degrees in (-180, 180].
int sector_of(const features::Scenario& scenario) {
  const double turns = double{azimuth_of(scenario)} / (2 * std::numbers::pi);
  const int degrees = kSectorDegrees * static_cast<int>(std::lround(kDirectionSectors * turns));
  return degrees <= -180 ? degrees + 360 : degrees;
}

double mean_over(const std::vector<double>& values, const std::vector<std::size_t>& members) {
  double sum = 0;
  for (const std::size_t member : members) sum += values[member];
  return sum / static_cast<double>(members.size());
}

}  // namespace

std::vector<DirectionRow> direction_rows(const TrainTestSplit& split,
                                         const Evaluation& evaluation) {
  std::vector<DirectionRow> rows;
  for (const motion::Target target : motion::kTargets) {
    for (int azimuth = kSectorDegrees - 180; azimuth <= 180; azimuth += kSectorDegrees) {
      std::vector<std::size_t> members;
      for (std::size_t i = 0; i < split.tested.size(); ++i) {
        const features::Scenario& scenario = split.tested[i].scenario;
        if (scenario.target == target && sector_of(scenario) == azimuth) members.push_back(i);
      }
      if (members.empty()) continue;
      const double idle = mean_over(evaluation.rows.front().cost_ns, members);
      const double oracle = mean_over(evaluation.rows.back().cost_ns, members);
      for (const EvaluationRow& row : evaluation.rows) {
        const double cost = mean_over(row.cost_ns, members);
        rows.push_back({std::string(motion::name_of(target)), azimuth, members.size(), row.name,
                        cost, cost - oracle, protection_of(idle, cost, oracle)});
      }
    }
  }
  return rows;
}

}  // namespace flinch::train
