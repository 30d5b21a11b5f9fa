// SPDX-License-Identifier: MIT
#include "evolve/weakest/threat_cell.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/scenes/sample_count.h"
#include "train/evaluate/bins.h"

namespace flinch::evolve {
namespace {

using train::ScenarioDistribution;

std::vector<ThreatCell> all_cells() {
  std::vector<ThreatCell> cells;
  for (const motion::Target target : motion::kTargets)
    for (int direction = -3; direction <= 4; ++direction)
      for (int time = 0; time < static_cast<int>(train::kTimeBins.size()); ++time)
        cells.push_back({target, direction, time});
  return cells;
}

class ThreatCellTest : public testing::Test {
 protected:
  database::ClipLibrary library_ = database::authored_library(motion::default_character());
  motion::BodyModel bodies_ = motion::make_body_model(library_.character);

  features::Scenario draw(const ScenarioDistribution& distribution, int number) const {
    return sample_scenario(library_, bodies_, distribution, 1, static_cast<std::uint64_t>(number));
  }
};

TEST_F(ThreatCellTest, EveryThreatOfACellIsInThatCell) {
  for (const ThreatCell& cell : all_cells()) {
    const auto threats = threats_in(ScenarioDistribution{}, cell);
    ASSERT_TRUE(threats);
    for (int number = 0; number < tests::samples(20); ++number)
      EXPECT_EQ(cell_of(draw(*threats, number)), cell);
  }
}

// A small volleyball from the left half and a slow one from the front, by counting.
TEST_F(ThreatCellTest, KindsHaveTheSharesThatTheyHaveAmongTheThreatsOfTheCell) {
  ScenarioDistribution distribution;
  distribution.kinds.resize(2);
  distribution.kinds[0].azimuth = {{0, std::numbers::pi}};
  distribution.kinds[1].azimuth = {{motion::radians(-30.0), motion::radians(30.0)}};
  distribution.kinds[1].time_to_impact_s = {0.35, 0.6};
  distribution.kinds[1].target_weight = {3, 1, 1, 1};
  std::map<ThreatCell, std::array<int, 2>> counts;
  const int count = 40 * tests::samples(500);
  for (int number = 0; number < count; ++number) {
    const features::Scenario scenario = draw(distribution, number);
    ++counts[cell_of(scenario)][static_cast<std::size_t>(scenario.threat.kind)];
  }
  for (const ThreatCell& cell : all_cells()) {
    const auto threats = threats_in(distribution, cell);
    ASSERT_EQ(threats.has_value(), counts.contains(cell));
    if (!threats) continue;
    const double weight = threats->kinds[0].weight + threats->kinds[1].weight;
    const auto drawn = counts[cell];
    // Two kinds of weight 1, so the sum of a cell's weights is twice its share of all threats.
    const double expected = weight / 2 * count;
    EXPECT_NEAR(drawn[0] + drawn[1], expected, 5 * std::sqrt(expected) + 0.03 * expected);
    const double first = expected * threats->kinds[0].weight / weight;
    EXPECT_NEAR(drawn[0], first, 5 * std::sqrt(first) + 0.03 * first);
  }
}

TEST_F(ThreatCellTest, MirrorImagesAreOnTheOtherSide) {
  EXPECT_EQ(mirrored(ThreatCell{motion::Target::legs, 3, 1}),
            (ThreatCell{motion::Target::legs, -3, 1}));
  for (const int middle : {0, 4}) {
    const ThreatCell cell{motion::Target::head, middle, 0};
    EXPECT_EQ(mirrored(cell), cell);
  }
}

}  // namespace
}  // namespace flinch::evolve
