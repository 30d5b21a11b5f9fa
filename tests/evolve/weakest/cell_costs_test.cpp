// SPDX-License-Identifier: MIT
#include "evolve/weakest/cell_costs.h"

#include <gtest/gtest.h>

#include <limits>

namespace flinch::evolve {
namespace {

using motion::Target;

/// A scenario from the front (+X, direction 0) or the left (direction 2), with the damage of clips
/// 0, 1, … .
train::Observation observation(Target target, bool from_left, std::vector<float> damages) {
  train::Observation made;
  made.scenario.target = target;
  made.scenario.time_to_impact_s = 0.3F;
  made.scenario.threat.velocity =
      from_left ? Eigen::Vector3f(0, -9, -1) : Eigen::Vector3f(-9, 0, -1);
  for (std::size_t clip = 0; clip < damages.size(); ++clip) {
    train::Trial trial;
    trial.clip = static_cast<int>(clip);
    trial.impulse[motion::Body::head] = damages[clip];
    made.trials.push_back(trial);
  }
  return made;
}

class CellCostsTest : public testing::Test {
 protected:
  train::CostModel model_;  // damage to the head counts half, at a brawn of 0.5
  std::vector<train::Observation> observations_{
      observation(Target::head, false, {10, 4, 1}), observation(Target::head, false, {6, 8, 7}),
      observation(Target::head, true, {2, 2, 1}), observation(Target::legs, true, {20, 30, 0})};
  ThreatCell front_{Target::head, 0, 0};
  ThreatCell left_{Target::head, 2, 0};
  ThreatCell legs_{Target::legs, 2, 0};
};

TEST_F(CellCostsTest, AreMeansOfTheCheapestOfTheFirstClips) {
  const std::vector<CellCost> costs = cell_costs(observations_, model_, 2);
  ASSERT_EQ(costs.size(), 3U);
  EXPECT_EQ(costs[0].cell, front_);
  EXPECT_EQ(costs[0].scenarios, 2U);
  EXPECT_DOUBLE_EQ(costs[0].mean_ns, (4 + 6) / 2.0 / 2);
  EXPECT_DOUBLE_EQ(costs[1].mean_ns, 1);
  EXPECT_DOUBLE_EQ(costs[2].mean_ns, 10);
}

TEST_F(CellCostsTest, TheWeakestCellsAreThoseOfTheLargestMean) {
  const std::vector<CellCost> cells = weakest_cells(cell_costs(observations_, model_, 2), 2);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].cell, legs_);
  EXPECT_EQ(cells[1].cell, front_);
}

TEST_F(CellCostsTest, ACellOfFewScenariosIsNotAmongTheWeakest) {
  for (int k = 0; k < 10; ++k)
    for (const bool from_left : {false, true})
      observations_.push_back(observation(Target::head, from_left, {2, 2, 2}));
  const std::vector<CellCost> cells = weakest_cells(cell_costs(observations_, model_, 2), 9);
  ASSERT_EQ(cells.size(), 2U);  // 1 scenario of a mean of 8 is too few
  EXPECT_EQ(cells[0].cell, front_);
}

TEST_F(CellCostsTest, TheGainIsThatOfTheFurtherClips) {
  const OracleGain gain = oracle_gain(observations_, model_, 2, {}, 1);
  EXPECT_EQ(gain.scenarios, 4U);
  EXPECT_DOUBLE_EQ(gain.before_ns, (4 + 6 + 2 + 20) / 4.0 / 2);
  EXPECT_DOUBLE_EQ(gain.after_ns, (1 + 6 + 1 + 0) / 4.0 / 2);
  EXPECT_DOUBLE_EQ(gain.difference_ns.value, gain.after_ns - gain.before_ns);
  EXPECT_LT(gain.difference_ns.interval.low, gain.difference_ns.value);
  const std::array<ThreatCell, 2> heads{front_, left_};
  const OracleGain of_heads = oracle_gain(observations_, model_, 2, heads, 1);
  EXPECT_EQ(of_heads.scenarios, 3U);
  EXPECT_DOUBLE_EQ(of_heads.after_ns, (1 + 6 + 1) / 3.0 / 2);
}

}  // namespace
}  // namespace flinch::evolve
