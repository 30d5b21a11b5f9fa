// SPDX-License-Identifier: MIT
#include "train/scenario/threat_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/error_of.h"

namespace flinch::train {
namespace {

ThreatKind only_kind(const std::string& text) {
  const ScenarioDistribution distribution = parse_threats(text, "a.toml");
  EXPECT_EQ(distribution.kinds.size(), 1U);
  return distribution.kinds.front();
}

TEST(ThreatFile, TheDefaultIsTheDefaultDistribution) {
  const ScenarioDistribution built_in;
  const ScenarioDistribution shipped = find_threats("default");
  EXPECT_EQ(shipped.kinds, built_in.kinds);  // exactly: so all scenarios have the same bits
  EXPECT_EQ(shipped.time_to_impact_step_s, built_in.time_to_impact_step_s);
  EXPECT_EQ(shipped.idle_phase_count, built_in.idle_phase_count);
}

TEST(ThreatFile, WhatAKindLeavesOutIsThatOfTheDefault) {
  ThreatKind expected;
  expected.name = "ball";
  EXPECT_EQ(only_kind("[[kind]]\nname = \"ball\"\n"), expected);
}

TEST(ThreatFile, EveryKeySetsItsValue) {
  const ThreatKind kind = only_kind(R"([[kind]]
name = "knuckle"
weight = 2.5
radius_m = 0.04
mass_kg = [0.5, 1]
speed_mps = [3, 9]
azimuth_degrees = [[-90, 90], [170, 190]]
elevation_degrees = 0
time_to_impact_s = [0.1, 0.5]
targets = { head = 2, legs = 1 }
aim_radius_m = 0.05
restitution = 0.1
friction = 0.9
flight = "straight"
)");
  EXPECT_EQ(kind.name, "knuckle");
  EXPECT_EQ(kind.weight, 2.5);
  EXPECT_EQ(kind.radius_m, (ValueRange{0.04, 0.04}));
  EXPECT_EQ(kind.mass_kg, (ValueRange{0.5, 1}));
  EXPECT_EQ(kind.speed_mps, (ValueRange{3, 9}));
  ASSERT_EQ(kind.azimuth.size(), 2U);
  EXPECT_DOUBLE_EQ(kind.azimuth[0].max, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(kind.azimuth[1].min, std::numbers::pi * 17 / 18);
  EXPECT_EQ(kind.elevation, (ValueRange{0, 0}));
  EXPECT_EQ(kind.time_to_impact_s, (ValueRange{0.1, 0.5}));
  EXPECT_EQ(kind.target_weight, (motion::PerTarget<double>{2, 0, 0, 1}));
  EXPECT_EQ(kind.aim_radius_m, 0.05);
  EXPECT_EQ(kind.bounce, (features::Bounce{0.1, 0.9}));
  EXPECT_FALSE(kind.falls);
}

TEST(ThreatFile, ShippedBallsHaveTheDensityOfThingsThatAreThrown) {
  const ScenarioDistribution balls = find_threats("balls");
  std::vector<std::string> names;
  for (const ThreatKind& kind : balls.kinds) {
    SCOPED_TRACE(kind.name);
    names.push_back(kind.name);
    const auto volume = [](double radius_m) {
      return 4.0 / 3 * std::numbers::pi * radius_m * radius_m * radius_m;
    };
    EXPECT_GT(kind.mass_kg.min / volume(kind.radius_m.max), 30);    // kg/m^3: a beach ball has 3
    EXPECT_LT(kind.mass_kg.max / volume(kind.radius_m.min), 4000);  // iron has 7800
  }
  EXPECT_EQ(names, (std::vector<std::string>{"volleyball", "dodgeball", "baseball", "medicine_ball",
                                             "rock"}));
}

TEST(ThreatFile, AFistHasAReachAndFliesStraightAndABladeDoesNotBounce) {
  const ThreatKind fist =
      only_kind("[[kind]]\nname = \"jab\"\nshape = \"fist\"\nreach_m = [0.3, 0.6]\n");
  EXPECT_EQ(fist.shape, features::ThreatShape::fist);
  EXPECT_EQ(fist.reach_m, (ValueRange{0.3, 0.6}));
  EXPECT_FALSE(fist.falls);
  EXPECT_EQ(fist.bounce.restitution, 0);
  const ThreatKind blade = only_kind("[[kind]]\nname = \"knife\"\nshape = \"blade\"\n");
  EXPECT_EQ(blade.shape, features::ThreatShape::blade);
  EXPECT_TRUE(blade.falls);
  EXPECT_EQ(blade.bounce.restitution, 0);
}

TEST(ThreatFile, ARodIsSwungIfItHasAReachAndThrownIfNot) {
  const ThreatKind bat = only_kind(
      "[[kind]]\nname = \"bat\"\nshape = \"rod\"\nlength_m = [0.8, 0.9]\nradius_m = 0.03\n"
      "reach_m = 1\nbalance = 0.66\nstrikes_at = [0.7, 0.9]\ntilt_degrees = [-90, 90]\n"
      "grip_share = 0.25\ngrip_mass_kg = 2\n");
  EXPECT_EQ(bat.shape, features::ThreatShape::rod);
  EXPECT_TRUE(bat.is_driven());
  EXPECT_FALSE(bat.falls);
  EXPECT_EQ(bat.bounce.restitution, 0);
  EXPECT_EQ(bat.rod, (features::RodRanges{.length_m = {0.8, 0.9},
                                          .strikes_at = {0.7, 0.9},
                                          .tilt = {-std::numbers::pi / 2, std::numbers::pi / 2},
                                          .grip_share = {0.25, 0.25},
                                          .balance = 0.66,
                                          .grip_mass_kg = 2}));
  const ThreatKind stick =
      only_kind("[[kind]]\nname = \"stick\"\nshape = \"rod\"\nlength_m = 5\nspin_per_s = [1, 2]\n");
  EXPECT_FALSE(stick.is_driven());
  EXPECT_TRUE(stick.falls);
  EXPECT_EQ(stick.rod.length_m, (ValueRange{5, 5}));
  EXPECT_NEAR(stick.rod.spin.max, 4 * std::numbers::pi, 1e-12);
  EXPECT_TRUE(features::is_sound(bat));
  EXPECT_TRUE(features::is_sound(stick));
}

TEST(ThreatFile, WhatIsWrongIsSaidWithItsLine) {
  const auto refusal = [](const std::string& line) {
    return tests::error_of(
        [&] { parse_threats("[[kind]]\nname = \"a\"\n" + line + "\n", "a.toml"); });
  };
  using testing::HasSubstr;
  using testing::StartsWith;
  EXPECT_EQ(refusal("mass = 1").substr(0, 49),
            "a.toml:3: [[kind]] has an unknown key \"mass\"; it ");
  EXPECT_EQ(refusal("mass_kg = -1"),
            "a.toml:3: [[kind]] has mass_kg -1, which is not from 0.001 to 100 kg");
  EXPECT_THAT(refusal("mass_kg = [1, 0.5]"),
              HasSubstr("mass_kg from 1 to 0.5; give the smaller number first"));
  EXPECT_THAT(refusal("mass_kg = [1, 2, 3]"), HasSubstr("needs a number or [min, max]"));
  EXPECT_THAT(refusal("mass_kg = nan"), HasSubstr("not from"));
  EXPECT_THAT(refusal("radius_m = 2"), HasSubstr("not from 0.001 to 1 m"));
  EXPECT_THAT(refusal("speed_mps = 0"), HasSubstr("not from 0.1 to 200 m/s"));
  EXPECT_THAT(refusal("azimuth_degrees = [-60, 60]"), HasSubstr("such as [[-60, 60]]"));
  EXPECT_THAT(refusal("azimuth_degrees = [[60, -60]]"), HasSubstr("smaller number first"));
  std::string sectors = "[0, 1]";
  for (int k = 1; k < 17; ++k) sectors += ", [0, 1]";
  EXPECT_THAT(refusal("azimuth_degrees = [" + sectors + "]"), HasSubstr("more than 16 sectors"));
  EXPECT_THAT(refusal("elevation_degrees = [0, 90]"), HasSubstr("not from -89 to 89 degrees"));
  EXPECT_THAT(refusal("time_to_impact_s = [0.25, 0.33]"),
              HasSubstr("not a whole number of steps of 0.05 s"));
  EXPECT_THAT(refusal("targets = { nose = 1 }"), HasSubstr("head, trunk, pelvis, legs"));
  EXPECT_THAT(refusal("targets = { head = 0 }"), HasSubstr("above 0"));
  EXPECT_THAT(refusal("restitution = 1.1"), HasSubstr("not from 0 to 1"));
  EXPECT_THAT(refusal("flight = \"curved\""), HasSubstr("known are: falling, straight"));
  EXPECT_THAT(refusal("shape = \"net\""), HasSubstr("known are: ball, blade, fist, rod"));
  EXPECT_EQ(refusal("shape = \"rod\"\nlength_m = 5.5"),
            "a.toml:4: [[kind]] has length_m 5.5, which is not from 0.05 to 5 m");
  EXPECT_THAT(refusal("shape = \"rod\""), HasSubstr("needs length_m"));
  EXPECT_THAT(refusal("shape = \"rod\"\nradius_m = 0.1\nlength_m = [0.2, 1]"),
              HasSubstr("a.toml:5: [[kind]] has a rod that is not longer than it is thick, 0.2 m"));
  EXPECT_THAT(refusal("length_m = 1"),
              HasSubstr("a.toml:3: [[kind]] has length_m, which only a rod has"));
  const std::string rod = "shape = \"rod\"\nlength_m = 1\n";
  EXPECT_THAT(refusal(rod + "grip_share = 0.2"), HasSubstr("only a swung rod has"));
  EXPECT_THAT(refusal(rod + "reach_m = 1\nspin_per_s = 1"), HasSubstr("only a thrown rod has"));
  EXPECT_THAT(refusal(rod + "strikes_at = 1.1"), HasSubstr("not from 0 to 1"));
  EXPECT_THAT(refusal(rod + "balance = -0.1"), HasSubstr("not from 0 to 1"));
  EXPECT_THAT(refusal(rod + "spin_per_s = 21"), HasSubstr("not from 0 to 20 turns per second"));
  EXPECT_THAT(refusal(rod + "reach_m = 1\nflight = \"falling\""),
              HasSubstr("has a rod that falls"));
  EXPECT_EQ(refusal("shape = \"blade\"\nrestitution = 0.1"),
            "a.toml:4: [[kind]] has a blade that bounces; a blade's restitution is 0");
  EXPECT_THAT(refusal("shape = \"fist\""), HasSubstr("needs reach_m"));
  EXPECT_THAT(refusal("reach_m = 0.5"), HasSubstr("a.toml:3: [[kind]] has reach_m, which only"));
  EXPECT_THAT(refusal("shape = \"fist\"\nreach_m = 6"), HasSubstr("not from 0.05 to 5 m"));
  EXPECT_THAT(refusal("shape = \"fist\"\nreach_m = 1\nflight = \"falling\""),
              HasSubstr("a.toml:5: [[kind]] has a fist that falls"));
  EXPECT_THAT(refusal("weight = 0"), HasSubstr("only kinds of weight 0"));
  EXPECT_THAT(refusal("[[kind]]\nname = \"a\""), StartsWith("a.toml:4: [[kind]] has the name of"));
  EXPECT_THAT(refusal("[[kind]]\nname = \"b\"\ntime_to_impact_s = [0.28, 0.58]"),
              StartsWith("a.toml:5: "));
  EXPECT_THAT(refusal("[[kind]]"), HasSubstr("needs name"));
  EXPECT_THAT(tests::error_of([] { parse_threats("kind = 1\n", "a.toml"); }),
              HasSubstr("at least one [[kind]]"));
  EXPECT_THAT(tests::error_of([] { parse_threats("", "a.toml"); }),
              HasSubstr("at least one [[kind]]"));
  EXPECT_EQ(
      tests::error_of([] { find_threats("cats"); }),
      "there are no threats named cats; shipped are: default, balls, kinds; a name that ends in "
      ".toml is that of a file");
}

}  // namespace
}  // namespace flinch::train
