// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/train/evaluate/comparison.h"

namespace flinch::train {
namespace {

/// Whether an azimuth is nearest to the middle of this sector, by comparing angles on the circle.
bool is_nearest(double azimuth, int middle_degrees) {
  const double away = azimuth - middle_degrees * std::numbers::pi / 180;
  return std::cos(away) >= std::cos(std::numbers::pi / kDirectionSectors) - 1e-9;
}

TEST(Directions, CellsHoldEachScenarioOnceAndGiveTheRowsMeansTogether) {
  const Comparison comparison(split_of(made_up_store(400)));
  const std::vector<DirectionRow> cells = direction_rows(comparison.split, comparison.evaluation);
  std::map<std::string, double> cost;
  std::map<std::string, std::size_t> scenarios;
  for (const DirectionRow& cell : cells) {
    EXPECT_GT(cell.azimuth_degrees, -180);
    EXPECT_LE(cell.azimuth_degrees, 180);
    std::size_t members = 0;
    for (const Observation& observation : comparison.split.tested)
      members += motion::name_of(observation.scenario.target) == cell.target &&
                 is_nearest(azimuth_of(observation.scenario), cell.azimuth_degrees);
    EXPECT_EQ(cell.scenarios, members) << cell.target << ' ' << cell.azimuth_degrees;
    cost[cell.name] += static_cast<double>(cell.scenarios) * cell.mean_cost_ns;
    scenarios[cell.name] += cell.scenarios;
    if (cell.name == "oracle") {
      EXPECT_EQ(cell.regret_ns, 0);
    }
    if (cell.name == "idle" && std::isfinite(cell.protection)) {
      EXPECT_EQ(cell.protection, 0);
    }
  }
  ASSERT_EQ(cost.size(), comparison.evaluation.rows.size());
  for (const EvaluationRow& row : comparison.evaluation.rows) {
    EXPECT_EQ(scenarios[row.name], row.cost_ns.size());
    EXPECT_NEAR(cost[row.name] / static_cast<double>(row.cost_ns.size()), row.mean_cost_ns.value,
                1e-9);
  }
}

TEST(Confusions, TheDiagonalIsTheAccuracyAndAllCellsAreTheRegret) {
  const Comparison comparison(split_of(made_up_store(400)));
  const std::vector<ConfusionRow> cells = confusion_rows(comparison.split, comparison.evaluation);
  struct Sums {
    double hits = 0, regret_ns = 0, scenarios = 0;
  };
  std::map<std::string, Sums> sums;
  for (const ConfusionRow& cell : cells) {
    EXPECT_GT(cell.scenarios, 0U);
    const auto count = static_cast<double>(cell.scenarios);
    Sums& sum = sums[cell.name];
    sum.scenarios += count;
    sum.regret_ns += count * cell.mean_regret_ns;
    if (cell.label == cell.chosen) sum.hits += count;
  }
  ASSERT_EQ(sums.size(), 3U);
  for (const char* name : {"nearest_annotation", "knn", "svm"}) {
    const EvaluationRow& row = *row_named(comparison.evaluation, name);
    EXPECT_EQ(sums[name].scenarios, static_cast<double>(row.chosen.size()));
    EXPECT_NEAR(sums[name].hits / sums[name].scenarios, row.accuracy.value, 1e-12);
    EXPECT_NEAR(sums[name].regret_ns / sums[name].scenarios, row.regret_ns.value, 1e-9);
  }
}

}  // namespace
}  // namespace flinch::train
