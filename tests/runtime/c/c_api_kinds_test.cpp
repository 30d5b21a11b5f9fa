// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/runtime/c/c_api_scene.h"

namespace flinch::runtime {
namespace {

using tests::sized;

/// A library that was trained for volleyballs and for punches.
class CApiKinds : public tests::CApi {
 protected:
  void SetUp() override {
    tests::MadeUpSelector made = tests::made_up_selector(
        database::authored_library(motion::default_character()), 60, tests::ModelKind::knn);
    features::KnownKind punch;
    punch.name = "punch";
    punch.shape = features::ThreatShape::fist;
    punch.falls = false;
    punch.speed_mps = {6, 11};
    punch.mass_kg = {1, 5};
    punch.reach_m = {0.4, 0.7};
    made.selector.kinds.push_back(punch);
    features::KnownKind bat = punch;
    bat.name = "bat";
    bat.shape = features::ThreatShape::rod;
    bat.radius_m = {0.03, 0.03};
    bat.rod = {.length_m = {0.8, 0.9}, .strikes_at = {0.7, 0.9}, .balance = 0.6, .grip_mass_kg = 2};
    made.selector.kinds.push_back(bat);
    library = tests::load(made.file());
    ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
    ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  }

  /// At the head of a character at the origin: waits, then moves 0.6 m in 0.075 s.
  static flinch_threat punch(float starts_in_s) {
    flinch_threat threat = tests::ball();
    const float velocity[3] = {-8, 0, 0};
    const float position[3] = {0.65F, 0, 1.6F};
    std::copy_n(position, 3, threat.position);
    std::copy_n(velocity, 3, threat.velocity);
    threat.radius = 0.105F;
    threat.mass_kg = 3;
    threat.kind = 1;
    threat.starts_in_s = starts_in_s;
    threat.lasts_s = 0.075F;
    return threat;
  }
};

TEST_F(CApiKinds, ASwungRodIsPerceivedByItsTurn) {
  // Its grip stays beside the head; in 0.1 s its tip turns a quarter of a circle, to the head.
  flinch_threat bat = punch(0.4F);
  bat.kind = 2;
  bat.radius = 0.03F;
  const float grip[3] = {0, 0.7F, 1.6F};
  std::copy_n(grip, 3, bat.position);
  std::fill_n(bat.velocity, 3, 0.0F);
  bat.axis[0] = 1;
  bat.angular_velocity[2] = -15.7F;
  bat.to_tip_m = 0.8F;
  bat.lasts_s = 0.15F;
  ASSERT_EQ(perceive(bat), FLINCH_OK);
  EXPECT_GT(state().time_to_impact_s, 0.4F);
  EXPECT_LE(state().time_to_impact_s, 0.51F);
  EXPECT_EQ(state().target, FLINCH_HEAD);
  flinch_threat away = bat;
  away.angular_velocity[2] = 15.7F;
  EXPECT_EQ(perceive(away), FLINCH_MISSES);
  flinch_threat unsound = bat;
  unsound.axis[0] = 0;
  EXPECT_EQ(perceive(unsound), FLINCH_BAD_THREAT);
  unsound = bat;
  unsound.to_tip_m = 5.1F;
  EXPECT_EQ(perceive(unsound), FLINCH_BAD_THREAT);
  auto kind = sized<flinch_kind>();
  ASSERT_EQ(flinch_library_kind(library, 2, &kind), FLINCH_OK);
  EXPECT_EQ(kind.shape, FLINCH_ROD);
  EXPECT_EQ(kind.length_m[1], 0.9F);
}

TEST_F(CApiKinds, AreThoseThatTheSelectorWasTrainedFor) {
  auto info = sized<flinch_library_info>();
  ASSERT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  ASSERT_EQ(info.kind_count, 3);
  auto kind = sized<flinch_kind>();
  ASSERT_EQ(flinch_library_kind(library, 0, &kind), FLINCH_OK);
  EXPECT_EQ(std::string(kind.name), "volleyball");
  EXPECT_EQ(kind.shape, FLINCH_BALL);
  EXPECT_EQ(kind.is_straight, 0);
  EXPECT_EQ(kind.restitution, 0.7F);
  ASSERT_EQ(flinch_library_kind(library, 1, &kind), FLINCH_OK);
  EXPECT_EQ(std::string(kind.name), "punch");
  EXPECT_EQ(kind.shape, FLINCH_FIST);
  EXPECT_EQ(kind.is_straight, 1);
  EXPECT_EQ(kind.reach_m[1], 0.7F);
  EXPECT_EQ(kind.speed_mps[0], 6);
  for (const std::int32_t bad : {-1, 3})
    EXPECT_EQ(flinch_library_kind(library, bad, &kind), FLINCH_BAD_INDEX);
  kind.size = 8;
  EXPECT_EQ(flinch_library_kind(library, 0, &kind), FLINCH_BAD_SIZE);
}

TEST_F(CApiKinds, AFistIsPerceivedByItsStroke) {
  const flinch_threat soon = punch(0.5F);
  ASSERT_EQ(perceive(soon), FLINCH_OK);
  EXPECT_GT(state().time_to_impact_s, 0.5F);
  EXPECT_LE(state().time_to_impact_s, 0.576F);
  flinch_threat short_of_it = soon;
  short_of_it.lasts_s = 0.03F;
  EXPECT_EQ(perceive(short_of_it), FLINCH_MISSES);
  flinch_threat unknown = soon;
  for (const std::int32_t bad : {-1, 3}) {
    unknown.kind = bad;
    EXPECT_EQ(perceive(unknown), FLINCH_BAD_THREAT);
  }
}

TEST_F(CApiKinds, AThreatUnlikeThoseOfTrainingIsAnsweredAndSaysSo) {
  flinch_threat threat = tests::ball();
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  flinch_outside outside[FLINCH_MOST_OUTSIDE];
  std::int32_t count = -1;
  const auto ask = [&] {
    return flinch_character_outside_training(character, &threat, outside, FLINCH_MOST_OUTSIDE,
                                             &count);
  };
  EXPECT_EQ(ask(), FLINCH_OK);
  EXPECT_EQ(count, 0);
  threat.mass_kg = 5;
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  EXPECT_EQ(ask(), FLINCH_OUTSIDE_TRAINING);
  ASSERT_EQ(count, 1);
  EXPECT_EQ(std::string(outside[0].name), "mass_kg");
  EXPECT_EQ(outside[0].value, 5);
  EXPECT_EQ(outside[0].trained[1], 0.27F);
  EXPECT_EQ(flinch_character_outside_training(character, &threat, nullptr, 0, &count),
            FLINCH_OUTSIDE_TRAINING);
  EXPECT_EQ(count, 0);
  threat.kind = 9;
  EXPECT_EQ(ask(), FLINCH_BAD_THREAT);
}

}  // namespace
}  // namespace flinch::runtime
