// SPDX-License-Identifier: MIT
#include "features/feature_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/features/moving_figure.h"
#include "tests/motion/random_motion.h"

namespace flinch::features {
namespace {

const Layout& layout(const char* set) {
  return feature_set_named(set)->layout;
}

IdlingFigure idling(const tests::SwayingFigure& figure) {
  return {&figure.character.skeleton, &figure.model, figure.idle};
}

Scenario random_scenario(std::mt19937& random) {
  Scenario scenario;
  scenario.threat.position = tests::random_vector(random, 10);
  scenario.threat.velocity = tests::random_vector(random, 20);
  scenario.target = static_cast<motion::Target>(random() % 4);
  scenario.time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
  scenario.state = {.idle_time_s = tests::uniform(random, 0, 5),
                    .position = tests::random_vector(random, 3).head<2>(),
                    .facing = tests::uniform(random, -3, 3)};
  return scenario;
}

TEST(Layout, RoundTripsThroughItsNames) {
  for (const FeatureSet& set : feature_sets()) {
    const std::vector<std::string> names = set.layout.names();
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(Layout::of(names), set.layout) << set.name;
  }
}

TEST(Layout, RefusesUnknownRepeatedOrNoNames) {
  EXPECT_FALSE(Layout::of(std::vector<std::string>{}));
  EXPECT_FALSE(Layout::of(std::vector<std::string>{"speed_mps", "speed_mph"}));
  EXPECT_FALSE(Layout::of(std::vector<std::string>{"speed_mps", "contact_x", "speed_mps"}));
  EXPECT_FALSE(Layout::of(std::vector<std::string>(1000, "speed_mps")));
  EXPECT_TRUE(Layout::of(std::vector<std::string>{"contact_x", "speed_mps"}));
}

TEST(Layout, WithoutAGroupKeepsTheOrderOfTheOthers) {
  const Layout all = with_stances(layout("both"));
  for (const FeatureGroup& group : feature_groups()) {
    std::vector<std::string> expected;
    for (const std::string& name : all.names())
      if (std::ranges::find(group.components, name) == group.components.end())
        expected.push_back(name);
    EXPECT_EQ(without(all, group).names(), expected) << group.name;
    EXPECT_LT(expected.size(), all.names().size()) << group.name;
  }
}

TEST(Layout, EveryComponentIsInExactlyOneGroup) {
  for (const std::string& name : with_stances(layout("both")).names()) {
    int groups = 0;
    for (const FeatureGroup& group : feature_groups())
      groups += static_cast<int>(std::ranges::count(group.components, name));
    EXPECT_EQ(groups, 1) << name;
  }
}

TEST(Layout, TellsKindsSizesAndMassesApartWhereTheyDiffer) {
  const Layout& paper = layout("paper");
  const auto added = [&](std::vector<KnownKind> kinds) {
    std::vector<std::string> names = with_kinds(paper, kinds).names();
    names.erase(names.begin(), names.begin() + paper.size());
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(added({KnownKind{}}), Names{});
  KnownKind other;
  EXPECT_EQ(added({KnownKind{}, other}), (Names{"kind_0", "kind_1"}));
  other.mass_kg = {1, 1};
  EXPECT_EQ(added({KnownKind{}, other}), (Names{"mass_kg", "log_impulse", "kind_0", "kind_1"}));
  EXPECT_EQ(added({other}), Names{}) << "one mass";
  other.mass_kg = {1, 2};
  other.radius_m = {0.1, 0.2};
  EXPECT_EQ(added({other}), (Names{"radius_m", "mass_kg", "log_impulse"}));
  EXPECT_EQ(added(std::vector<KnownKind>(kMaxThreatKinds)).back(), "kind_15");
}

TEST(FeatureVectors, HoldTheThreatsSizeMassAndKind) {
  const tests::SwayingFigure figure;
  std::mt19937 random(9);
  const Layout of_threat = *Layout::of(std::vector<std::string>{
      "kind_2", "mass_kg", "kind_0", "speed_mps", "radius_m", "kind_1", "log_impulse"});
  Scenario scenario = random_scenario(random);
  scenario.threat.radius = 0.25F;
  scenario.threat.mass_kg = 3;
  scenario.threat.kind = 2;
  const FeatureVector x = feature_vector(of_threat, scenario, idling(figure));
  EXPECT_EQ((std::vector<float>{x[0], x[1], x[2], x[4], x[5]}),
            (std::vector<float>{1, 3, 0, 0.25F, 0}));
  EXPECT_NEAR(x[3], scenario.threat.velocity.norm(), 1e-4F);
  const float impact_mps = velocity_at(scenario.threat, scenario.time_to_impact_s).norm();
  EXPECT_NEAR(x[6], std::log(1.7F * 3 * impact_mps), 1e-5F);
  EXPECT_EQ(of_threat.kind_in(x), 2U);
  EXPECT_EQ(layout("paper").kind_in(x), 0U);
}

TEST(FeatureVectors, FollowTheLayoutsOrder) {
  const tests::SwayingFigure figure;
  std::mt19937 random(5);
  std::vector<std::string> names = layout("both").names();
  std::ranges::shuffle(names, random);
  const Layout shuffled = *Layout::of(names);
  const Scenario scenario = random_scenario(random);
  const FeatureVector in_order = feature_vector(layout("both"), scenario, idling(figure));
  const FeatureVector other = feature_vector(shuffled, scenario, idling(figure));
  for (int i = 0; i < shuffled.size(); ++i) {
    int place = 0;
    while (layout("both").name(place) != shuffled.name(i)) ++place;
    EXPECT_EQ(other[static_cast<std::size_t>(i)], in_order[static_cast<std::size_t>(place)]);
  }
}

TEST(FeatureVectors, PaperSetMatchesThePapersFeatures) {
  const tests::SwayingFigure figure;
  std::mt19937 random(6);
  for (int i = 0; i < 50; ++i) {
    const Scenario scenario = random_scenario(random);
    EXPECT_EQ(feature_vector(layout("paper"), scenario, idling(figure)),
              to_vector(features_of(scenario, figure.idle)));
  }
}

TEST(FeatureVectors, AreInvariantToRigidMotionOfTheWorld) {
  const tests::SwayingFigure figure;
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = random_scenario(random);
    const float yaw = tests::uniform(random, -3, 3);
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    Eigen::Vector3f move = tests::random_vector(random, 5);
    move.z() = 0;
    Scenario moved = scenario;
    const Eigen::Vector3f stand(scenario.state.position.x(), scenario.state.position.y(), 0);
    moved.state.facing += yaw;
    moved.state.position = (turn * stand + move).head<2>();
    moved.threat.position = turn * scenario.threat.position + move;
    moved.threat.velocity = turn * scenario.threat.velocity;
    const FeatureVector before = feature_vector(layout("both"), scenario, idling(figure));
    const FeatureVector after = feature_vector(layout("both"), moved, idling(figure));
    for (std::size_t k = 0; k < before.size(); ++k)
      EXPECT_NEAR(after[k], before[k], 2e-4F) << layout("both").name(static_cast<int>(k));
  }
}

// A described threat assumes a character that stands still: a figure that does not sway has the
// same features, wherever its targets are.
TEST(FeatureVectors, ForADescribedThreatMatchAStandingCharacter) {
  tests::SwayingFigure figure;
  motion::Pose pose = figure.idle.poses.front();
  pose.root_position.head<2>().setZero();
  pose.rotation[motion::Role::pelvis] = Eigen::Quaternionf::Identity();
  figure.idle.poses = {pose};
  std::mt19937 random(8);
  for (int i = 0; i < 50; ++i) {
    Scenario scenario = random_scenario(random);
    scenario.state = {};
    const motion::PerTarget<Eigen::Vector3f> centres =
        predict_character(idling(figure), {}, 0).target_centres;
    for (const FeatureSet& set : feature_sets()) {
      const FeatureVector played = feature_vector(set.layout, scenario, idling(figure));
      const FeatureVector described = feature_vector(set.layout, scenario, centres);
      for (std::size_t k = 0; k < played.size(); ++k)
        EXPECT_NEAR(played[k], described[k], 1e-5F) << set.name << ' ' << k;
    }
  }
}

TEST(FeatureVectors, AreFiniteForExtremeInput) {
  const tests::SwayingFigure figure;
  constexpr float kHuge = std::numeric_limits<float>::max();
  for (const float huge : {kHuge, -kHuge, 1e20F}) {
    Scenario scenario;
    scenario.threat.position = {huge, -huge, huge};
    scenario.threat.velocity = {-huge, huge, huge};
    scenario.time_to_impact_s = 100;
    for (const float value : feature_vector(layout("both"), scenario, idling(figure)))
      EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace flinch::features
