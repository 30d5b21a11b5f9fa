// SPDX-License-Identifier: MIT
#include "features/stance_features.h"

#include <gtest/gtest.h>

#include "features/feature_layout.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/scenes/walk.h"

namespace flinch::features {
namespace {

/// A walk of 0.9 m/s whose feet are known in closed form (tests/scenes/walk.h).
struct Walker {
  motion::Physique character = motion::default_character();
  motion::Figure made = motion::make_figure(character);
  motion::Motion walk = tests::walking(made);

  IdlingFigure figure() const {
    return {&made.skeleton(), &made.bodies, motion::Loop::in_cycles(walk)};
  }
};

TEST(StanceFeatures, AreThoseOfTheWalkInTheCharactersFrame) {
  const Walker walker;
  const IdlingFigure figure = walker.figure();
  for (const float facing : {0.0F, 1.0F, -2.5F}) {
    for (float time_s = 0; time_s < 2; time_s += 0.13F) {
      const CharacterState state{0.3F, {2, -1}, facing, 1};
      const StanceFeatures found = stance_features(figure, state, time_s);
      EXPECT_NEAR(found.velocity_x, 0.9F, 1e-3F);
      EXPECT_NEAR(found.velocity_y, 0, 1e-3F);
      EXPECT_NEAR(found.turn_rate, 0, 1e-3F);
      EXPECT_NEAR(found.left_hand_y + found.right_hand_y, 0, 2e-2F);
    }
  }
}

// The body passes over the foot that stands alone, and then that foot carries the weight.
TEST(StanceFeatures, TellWhichFootCarriesTheWeight) {
  const Walker walker;
  const tests::Walk walk;
  float least = 1;
  float most = 0;
  for (float time_s = 0; time_s < walk.cycle_s; time_s += 1.0F / 60) {
    const motion::Skeleton& skeleton = walker.made.skeleton();
    const auto height = [&](motion::Side side) {
      return tests::walking_foot(skeleton, side, walk, time_s).ankle.z();
    };
    const StanceFeatures found = stance_features(walker.figure(), {0, {0, 0}, 0, 1}, time_s);
    EXPECT_GE(found.weight_left, 0);
    EXPECT_LE(found.weight_left, 1);
    if (height(motion::Side::right) > height(motion::Side::left) + 0.07F) {
      EXPECT_GT(found.weight_left, 0.5F) << time_s;
    }
    if (height(motion::Side::left) > height(motion::Side::right) + 0.07F) {
      EXPECT_LT(found.weight_left, 0.5F) << time_s;
    }
    least = std::min(least, found.weight_left);
    most = std::max(most, found.weight_left);
  }
  EXPECT_LT(least, 0.4F);
  EXPECT_GT(most, 0.6F);
}

TEST(StanceFeatures, ALayoutHasThemWhereItNamesThem) {
  const Walker walker;
  const Layout plain = feature_set_named("geometry")->layout;
  const Layout layout = with_stances(plain);
  EXPECT_FALSE(plain.has_stance());
  EXPECT_TRUE(layout.has_stance());
  EXPECT_EQ(layout.size(), plain.size() + kStanceFeatureCount);
  Scenario scenario;
  scenario.state = {0.3F, {2, -1}, 0.4F, 1};
  scenario.threat.position = {4, 0, 1.5F};
  scenario.threat.velocity = {-8, 0, 2};
  const FeatureVector x = feature_vector(layout, scenario, walker.figure());
  const StanceFeatures expected =
      stance_features(walker.figure(), scenario.state, scenario.time_to_impact_s);
  const auto at = static_cast<std::size_t>(plain.size());
  EXPECT_EQ(x[at], expected.velocity_x);
  EXPECT_EQ(x[at + 3], expected.weight_left);
  EXPECT_EQ(x[at + 9], expected.right_hand_z);
}

}  // namespace
}  // namespace flinch::features
