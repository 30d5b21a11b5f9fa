// SPDX-License-Identifier: MIT
#include "models/training_range.h"

#include <gtest/gtest.h>

#include <numbers>

namespace flinch::models {
namespace {

Selector two_kinds() {
  Selector selector;
  features::KnownKind stone;
  stone.name = "stone";
  stone.radius_m = {0.02, 0.04};
  stone.mass_kg = {0.1, 0.3};
  stone.speed_mps = {5, 10};
  stone.elevation = {motion::radians(-5.0), motion::radians(30.0)};
  stone.time_to_impact_s = {0.3, 0.6};
  stone.falls = false;
  selector.kinds.push_back(stone);
  return selector;
}

/// A stone in the middle of its ranges.
features::ThreatDescription stone() {
  return {.elevation = motion::radians(10.0F),
          .speed_mps = 8,
          .time_to_impact_s = 0.5F,
          .radius = 0.03F,
          .mass_kg = 0.2F,
          .falls = false,
          .kind = 1};
}

std::vector<std::string> outside(const features::ThreatDescription& description) {
  features::Scenario scenario;
  scenario.threat = threat_from_description(description, {0, 0, 1.5F}, 0);
  scenario.time_to_impact_s = description.time_to_impact_s;
  std::vector<std::string> names;
  for (const OutsideTraining& number : outside_training(two_kinds(), scenario)) {
    names.emplace_back(number.name);
    EXPECT_TRUE(number.value < number.trained.min || number.value > number.trained.max);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(OutsideTraining, NamesAReachThatNoFistHad) {
  Selector selector = two_kinds();
  selector.kinds[1].shape = features::ThreatShape::fist;
  selector.kinds[1].reach_m = {0.4, 0.7};
  features::ThreatDescription punch = stone();
  const auto names = [&](float reach_m) {
    punch.reach_m = reach_m;
    features::Scenario scenario;
    scenario.threat = threat_from_description(punch, {0, 0, 1.5F}, 0);
    scenario.time_to_impact_s = punch.time_to_impact_s;
    Names found;
    for (const OutsideTraining& number : outside_training(selector, scenario))
      found.emplace_back(number.name);
    return found;
  };
  EXPECT_EQ(names(0.7F), Names{});
  EXPECT_EQ(names(0.8F), Names{"reach_m"});
}

TEST(OutsideTraining, IsNothingWithinAndAtTheEndsOfTheRanges) {
  EXPECT_EQ(outside(stone()), Names{});
  features::ThreatDescription end = stone();
  end.radius = 0.04F;
  end.mass_kg = 0.1F;
  end.speed_mps = 10;
  end.elevation = motion::radians(30.0F);
  end.time_to_impact_s = 0.3F;
  EXPECT_EQ(outside(end), Names{});
  EXPECT_EQ(outside({.elevation = 0.2F, .speed_mps = 30, .time_to_impact_s = 1.2F}), Names{});
}

TEST(OutsideTraining, NamesEachNumberThatIsOutside) {
  const auto with = [](auto change) {
    features::ThreatDescription description = stone();
    change(description);
    return outside(description);
  };
  EXPECT_EQ(with([](auto& d) { d.radius = 0.05F; }), Names{"radius_m"});
  EXPECT_EQ(with([](auto& d) { d.mass_kg = 0.09F; }), Names{"mass_kg"});
  EXPECT_EQ(with([](auto& d) { d.speed_mps = 11; }), Names{"speed_mps"});
  EXPECT_EQ(with([](auto& d) { d.elevation = motion::radians(-8.0F); }),
            Names{"elevation_degrees"});
  EXPECT_EQ(with([](auto& d) { d.time_to_impact_s = 0.7F; }), Names{"time_to_impact_s"});
  EXPECT_EQ(with([](auto& d) { d.kind = 2; }), Names{"kind"});
  EXPECT_EQ(with([](auto& d) { d.kind = 0; }), (Names{"radius_m", "mass_kg"}));
  EXPECT_EQ(with([](auto& d) { d.mass_kg = 1, d.speed_mps = 3; }), (Names{"mass_kg", "speed_mps"}));
}

// A volleyball that falls for a second arrives faster than it started: the speed that counts is
// that of the impact.
TEST(OutsideTraining, TakesSpeedAndElevationAtTheImpact) {
  EXPECT_EQ(outside({.elevation = 0.3F, .speed_mps = 8.1F, .time_to_impact_s = 1}), Names{});
  EXPECT_EQ(outside({.elevation = 0.3F, .speed_mps = 7.5F, .time_to_impact_s = 1}),
            Names{"speed_mps"});
}

}  // namespace
}  // namespace flinch::models
