// SPDX-License-Identifier: MIT
#include "database/author/character_toml.h"

#include <gmock/gmock.h>

#include "motion/default_character.h"
#include "motion/figure.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using motion::Role;
using testing::HasSubstr;

motion::Physique character_of(const std::string& text) {
  const tests::TemporaryFolder folder;
  return read_character(folder.write("character.toml", text));
}

std::string error_of(const std::string& text) {
  return tests::error_of([&] { character_of(text); });
}

TEST(CharacterToml, AnEmptyFileIsTheDefaultCharacter) {
  const motion::Physique read = character_of("");
  const motion::Physique mean = motion::default_character();
  for (Role role : motion::kRoles) {
    EXPECT_LT((read.skeleton.offset[role] - mean.skeleton.offset[role]).norm(), 1e-5F)
        << motion::name_of(role);
    EXPECT_LT((read.skeleton.tip[role] - mean.skeleton.tip[role]).norm(), 1e-5F)
        << motion::name_of(role);
  }
  EXPECT_FLOAT_EQ(read.mass_kg, mean.mass_kg);
}

TEST(CharacterToml, AppliesHeightMassSexAndProportions) {
  const motion::Physique read =
      character_of("height_m = 1.62\nmass_kg = 58\nsex = \"female\"\n[proportions]\nlegs = 1.2\n");
  EXPECT_NEAR(stature(read.skeleton), 1.62F, 1e-4F);
  EXPECT_EQ(read.mass_kg, 58);
  EXPECT_EQ(read.sex, motion::Sex::female);
  const motion::Skeleton& mean = motion::default_character().skeleton;
  const auto legs_to_arms = [](const motion::Skeleton& skeleton) {
    return limb_length(skeleton, motion::Limb::left_leg) /
           limb_length(skeleton, motion::Limb::left_arm);
  };
  EXPECT_NEAR(legs_to_arms(read.skeleton), 1.2F * legs_to_arms(mean), 1e-4F);
  const motion::JointFrames rest =
      motion::forward_kinematics(read.skeleton, motion::rest_pose(read.skeleton));
  EXPECT_GT(rest.position[Role::left_toes].z(), 0);
}

TEST(CharacterToml, RefusesImplausibleValuesWithFileAndLine) {
  EXPECT_THAT(error_of("height_m = 5\n"),
              HasSubstr(".toml:1: height_m 5 is outside the range of people"));
  EXPECT_THAT(error_of("height_m = 1.8\nmass_kg = -3\n"), HasSubstr(".toml:2: mass_kg"));
  EXPECT_THAT(error_of("[proportions]\n\narms = 3.0\n"), HasSubstr(".toml:3: arms 3"));
  EXPECT_THAT(error_of("sex = \"robot\"\n"), HasSubstr("female, male"));
  EXPECT_THAT(error_of("hieght_m = 1.8\n"), HasSubstr("height_m"));
  EXPECT_THAT(error_of("height_m = nan\n"), HasSubstr("height_m"));
}

}  // namespace
}  // namespace flinch::database
