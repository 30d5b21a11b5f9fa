// SPDX-License-Identifier: MIT
// Saved states, poses of clips, and options of reactions, in C.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "reaction/reacting_character.h"
#include "runtime/c/c_values.h"
#include "runtime/library.h"
#include "tests/runtime/c/c_api_scene.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"

namespace flinch::runtime {
namespace {

using tests::kNan;
using tests::sized;

constexpr float kStep_s = 1.0F / 60;

class CApiState : public tests::CApi {
 protected:
  flinch_pose pose_of_other(const flinch_character* other) const {
    auto value = sized<flinch_pose>();
    EXPECT_EQ(flinch_character_pose(other, &value), FLINCH_OK);
    return value;
  }
};

TEST_F(CApiState, ACopyGoesOnAsTheOriginalBitForBit) {
  flinch_character* saved = nullptr;
  ASSERT_EQ(flinch_character_create(library, &saved), FLINCH_OK);
  auto limits = sized<flinch_perception_limits>();
  ASSERT_EQ(flinch_human_limits(4, &limits), FLINCH_OK);
  ASSERT_EQ(flinch_character_limit_perception(character, &limits, 7), FLINCH_OK);
  for (int frame = 0; frame < 240; ++frame) {
    const flinch_threat threat = tests::ball();
    if (frame % 80 == 40) {
      ASSERT_GE(perceive(threat), FLINCH_OK);
      const std::size_t allocations = tests::allocation_count();
      ASSERT_EQ(flinch_character_copy(saved, character), FLINCH_OK);
      EXPECT_EQ(tests::allocation_count(), allocations);
    }
    ASSERT_EQ(flinch_character_update(character, kStep_s), FLINCH_OK);
    ASSERT_EQ(flinch_character_update(saved, kStep_s), FLINCH_OK);
    const flinch_pose copied = pose_of_other(saved);
    const flinch_pose original = pose();
    if (frame > 40) {
      ASSERT_EQ(std::memcmp(&original, &copied, sizeof copied), 0) << frame;
    }
  }
  EXPECT_EQ(flinch_character_free(saved), FLINCH_OK);
}

TEST_F(CApiState, OnlyLikeCharactersOfOneLibraryAreCopied) {
  flinch_library* other = tests::load(tests::selector_file());
  flinch_character* foreign = nullptr;
  flinch_character* reacting = nullptr;
  ASSERT_EQ(flinch_character_create(other, &foreign), FLINCH_OK);
  ASSERT_EQ(flinch_character_create_reacting(library, &reacting), FLINCH_OK);
  refuses(FLINCH_OTHER_LIBRARY, [&] { return flinch_character_copy(character, foreign); });
  refuses(FLINCH_BAD_HANDLE, [&] { return flinch_character_copy(character, reacting); });
  refuses(FLINCH_NULL_POINTER, [&] { return flinch_character_copy(character, nullptr); });
  EXPECT_EQ(flinch_character_copy(reacting, character), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_copy(character, character), FLINCH_OK);
  for (flinch_character* one : {foreign, reacting})
    EXPECT_EQ(flinch_character_free(one), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(other), FLINCH_OK);
}

TEST_F(CApiState, PosesOfClipsAreTheirSamples) {
  Library same;
  const std::string& file = tests::selector_file();
  ASSERT_EQ(same.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  const auto& clips = same.clip_library().clips;
  for (std::size_t clip = 0; clip < clips.size(); clip += 7) {
    for (const float time_s : {-1.0F, 0.0F, 0.123F, 0.5F, 1e6F}) {
      auto shown = sized<flinch_pose>();
      ASSERT_EQ(flinch_library_clip_pose(library, static_cast<std::int32_t>(clip), time_s, &shown),
                FLINCH_OK);
      flinch_pose wanted = to_c(motion::sample(clips[clip].motion, time_s));
      wanted.size = sizeof wanted;
      EXPECT_EQ(std::memcmp(&shown, &wanted, sizeof shown), 0) << clip << " at " << time_s;
    }
  }
  auto out = sized<flinch_pose>();
  const auto count = static_cast<std::int32_t>(clips.size());
  EXPECT_EQ(flinch_library_clip_pose(library, count, 0, &out), FLINCH_BAD_INDEX);
  EXPECT_EQ(flinch_library_clip_pose(library, -1, 0, &out), FLINCH_BAD_INDEX);
  EXPECT_EQ(flinch_library_clip_pose(library, 0, kNan, &out), FLINCH_BAD_TIME);
  EXPECT_EQ(flinch_library_clip_pose(library, 0, 1.1e6F, &out), FLINCH_BAD_TIME);
  EXPECT_EQ(flinch_library_clip_pose(library, 0, 0, nullptr), FLINCH_NULL_POINTER);
}

/// A ball that hits the chest of an idling character at the origin in 0.1 s.
flinch_threat near_ball_at_the_chest() {
  flinch_threat threat = tests::ball();
  const float position[3] = {1.2F, 0, 1.2F};
  const float velocity[3] = {-11, 0, 0.5F};
  std::copy_n(position, 3, threat.position);
  std::copy_n(velocity, 3, threat.velocity);
  return threat;
}

TEST_F(CApiState, OptionsOfReactionsAreThoseOfCxx) {
  auto options = sized<flinch_reaction_options>();
  ASSERT_EQ(flinch_reaction_defaults(&options), FLINCH_OK);
  const reaction::ReactionOptions usual;
  EXPECT_EQ(options.stiffness, static_cast<float>(usual.stiffness));
  EXPECT_EQ(options.simulation_only_s, static_cast<float>(usual.schedule.simulation_only_s));
  options.stiffness = 0.5F;
  options.simulation_only_s = 0.25F;
  flinch_character* stiff = nullptr;
  ASSERT_EQ(flinch_character_create_reacting_as(library, &options, &stiff), FLINCH_OK);
  runtime::Library same;
  const std::string& file = tests::selector_file();
  ASSERT_EQ(same.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  reaction::ReactingCharacter expected(same, reaction::make_reaction_data(same), {{0.25}, 0.5});
  const flinch_threat ball = near_ball_at_the_chest();
  ASSERT_EQ(flinch_character_react_to(stiff, &ball), FLINCH_OK);
  ASSERT_EQ(expected.react_to(features::ball_of(threat_of(ball, {}))),
            reaction::ReactionStatus::ok);
  for (int frame = 0; frame < 40; ++frame) {
    ASSERT_EQ(flinch_character_update(stiff, kStep_s), FLINCH_OK);
    ASSERT_EQ(expected.update(kStep_s), reaction::ReactionStatus::ok);
  }
  flinch_pose wanted = to_c(expected.pose());
  wanted.size = sizeof wanted;
  const flinch_pose shown = pose_of_other(stiff);
  EXPECT_EQ(std::memcmp(&shown, &wanted, sizeof shown), 0);
  EXPECT_EQ(flinch_character_free(stiff), FLINCH_OK);
}

TEST_F(CApiState, BadOptionsOfReactionsMakeNoCharacter) {
  auto usual = sized<flinch_reaction_options>();
  ASSERT_EQ(flinch_reaction_defaults(&usual), FLINCH_OK);
  const auto make = [&](float simulation_only_s, float stiffness) {
    auto options = usual;
    options.simulation_only_s = simulation_only_s;
    options.stiffness = stiffness;
    flinch_character* made = character;
    const flinch_status status = flinch_character_create_reacting_as(library, &options, &made);
    EXPECT_EQ(made == nullptr, status != FLINCH_OK);
    if (status == FLINCH_OK) flinch_character_free(made);
    return status;
  };
  EXPECT_EQ(make(0.05F, 1), FLINCH_OK);
  EXPECT_EQ(make(0.5F, 1e-3F), FLINCH_OK);
  EXPECT_EQ(make(0.049F, 1), FLINCH_BAD_LIMITS);
  EXPECT_EQ(make(0.51F, 1), FLINCH_BAD_LIMITS);
  EXPECT_EQ(make(kNan, 1), FLINCH_BAD_LIMITS);
  EXPECT_EQ(make(0.1F, 0), FLINCH_BAD_LIMITS);
  EXPECT_EQ(make(0.1F, 1.01F), FLINCH_BAD_LIMITS);
  EXPECT_EQ(make(0.1F, kNan), FLINCH_BAD_LIMITS);
}

TEST_F(CApiState, AReactionThatIsStoppedShowsTheCharactersOwnMotion) {
  flinch_character* reacting = nullptr;
  ASSERT_EQ(flinch_character_create_reacting(library, &reacting), FLINCH_OK);
  const flinch_threat ball = near_ball_at_the_chest();
  ASSERT_EQ(flinch_character_react_to(reacting, &ball), FLINCH_OK);
  for (int frame = 0; frame < 15; ++frame) {
    ASSERT_EQ(flinch_character_update(reacting, kStep_s), FLINCH_OK);
    ASSERT_EQ(flinch_character_update(character, kStep_s), FLINCH_OK);
  }
  auto now = sized<flinch_reaction>();
  ASSERT_EQ(flinch_character_reaction(reacting, &now), FLINCH_OK);
  ASSERT_EQ(now.moved_by, FLINCH_MOVED_BY_PHYSICS);
  const flinch_pose plain = pose();
  flinch_pose shown = pose_of_other(reacting);
  EXPECT_NE(std::memcmp(&shown, &plain, sizeof shown), 0);
  ASSERT_EQ(flinch_character_stop_reaction(reacting), FLINCH_OK);
  shown = pose_of_other(reacting);
  EXPECT_EQ(std::memcmp(&shown, &plain, sizeof shown), 0);
  ASSERT_EQ(flinch_character_reaction(reacting, &now), FLINCH_OK);
  EXPECT_EQ(now.moved_by, FLINCH_MOVED_BY_CHARACTER);
  refuses(FLINCH_NOT_REACTING, [&] { return flinch_character_stop_reaction(character); });
  EXPECT_EQ(flinch_character_free(reacting), FLINCH_OK);
}

}  // namespace
}  // namespace flinch::runtime
