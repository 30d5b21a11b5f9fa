// SPDX-License-Identifier: MIT
// Characters that balls hit, and the outlines of what they hit, in C.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
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

constexpr float kFrame_s = 1.0F / 60;

/// A ball that hits the chest of an idling character at the origin from 1 m in front, in 0.1 s.
flinch_threat near_ball() {
  flinch_threat threat = tests::ball();
  const float position[3] = {1.2F, 0, 1.2F};
  const float velocity[3] = {-11, 0, 0.5F};
  std::copy_n(position, 3, threat.position);
  std::copy_n(velocity, 3, threat.velocity);
  return threat;
}

class CApiReaction : public tests::CApi {
 protected:
  void SetUp() override {
    CApi::SetUp();
    ASSERT_EQ(flinch_character_free(character), FLINCH_OK);
    ASSERT_EQ(flinch_character_create_reacting(library, &character), FLINCH_OK);
  }

  flinch_reaction reaction() const {
    auto value = sized<flinch_reaction>();
    EXPECT_EQ(flinch_character_reaction(character, &value), FLINCH_OK);
    return value;
  }
};

TEST_F(CApiReaction, ShowsTheBitsOfTheCxxReaction) {
  runtime::Library same;
  const std::string& file = tests::selector_file();
  ASSERT_EQ(same.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  reaction::ReactingCharacter expected(same, reaction::make_reaction_data(same));
  const flinch_threat ball = near_ball();
  ASSERT_EQ(flinch_character_react_to(character, &ball), FLINCH_OK);
  ASSERT_EQ(expected.react_to(features::ball_of(threat_of(ball, {}))),
            reaction::ReactionStatus::ok);
  bool was_struck = false;
  for (int frame = 0; frame < 120; ++frame) {
    const std::size_t allocations = tests::allocation_count();
    ASSERT_EQ(flinch_character_update(character, kFrame_s), FLINCH_OK);
    EXPECT_EQ(tests::allocation_count(), allocations);
    ASSERT_EQ(expected.update(kFrame_s), reaction::ReactionStatus::ok);
    flinch_pose wanted = to_c(expected.pose());
    wanted.size = sizeof wanted;
    const flinch_pose shown = pose();
    ASSERT_EQ(std::memcmp(&shown, &wanted, sizeof shown), 0) << "frame " << frame;
    was_struck = was_struck || reaction().phase == FLINCH_REACTION_STRUCK;
  }
  EXPECT_TRUE(was_struck);
  const flinch_reaction after = reaction();
  EXPECT_EQ(after.moved_by, FLINCH_MOVED_BY_CHARACTER);
  EXPECT_EQ(after.phase, FLINCH_REACTION_OVER);
  EXPECT_TRUE(std::isfinite(after.contact_s));
  // A ball of 0.27 kg at 11 m/s that bounces back gives up to (1 + 0.7) 0.27 kg 11 m/s.
  const float sum_ns =
      std::accumulate(after.impulse_ns, after.impulse_ns + FLINCH_BODY_COUNT, 0.0F);
  EXPECT_GT(sum_ns, 1);
  EXPECT_LT(sum_ns, 1.7F * 0.27F * 11.1F);
}

TEST_F(CApiReaction, OlderProgramsGetWhatTheirStructHolds) {
  flinch_reaction older{};
  older.size = offsetof(flinch_reaction, ball_axis);
  older.ball_momentum[0] = 7;
  EXPECT_EQ(flinch_character_reaction(character, &older), FLINCH_OK);
  EXPECT_EQ(older.clip, -1);
  EXPECT_EQ(older.ball_momentum[0], 7);
  older.size -= 4;
  EXPECT_EQ(flinch_character_reaction(character, &older), FLINCH_BAD_SIZE);
}

TEST_F(CApiReaction, UntilItIsHitItAnticipatesAsOthersDo) {
  flinch_character* plain = nullptr;
  ASSERT_EQ(flinch_character_create(library, &plain), FLINCH_OK);
  const flinch_threat threat = tests::ball();
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  ASSERT_EQ(flinch_character_perceive(plain, &threat, workspace), FLINCH_OK);
  for (int frame = 0; frame < 60; ++frame) {
    ASSERT_EQ(flinch_character_update(character, kFrame_s), FLINCH_OK);
    ASSERT_EQ(flinch_character_update(plain, kFrame_s), FLINCH_OK);
    auto expected = sized<flinch_pose>();
    ASSERT_EQ(flinch_character_pose(plain, &expected), FLINCH_OK);
    const flinch_pose shown = pose();
    ASSERT_EQ(std::memcmp(&shown, &expected, sizeof shown), 0) << "frame " << frame;
  }
  EXPECT_EQ(reaction().phase, FLINCH_REACTION_NONE);
  EXPECT_EQ(flinch_character_free(plain), FLINCH_OK);
}

TEST_F(CApiReaction, PlacingTheCharacterEndsPhysics) {
  const flinch_threat ball = near_ball();
  ASSERT_EQ(flinch_character_react_to(character, &ball), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, kFrame_s), FLINCH_OK);
  EXPECT_EQ(reaction().moved_by, FLINCH_MOVED_BY_PHYSICS);
  ASSERT_EQ(flinch_character_place(character, 3, 4, 0, 0), FLINCH_OK);
  EXPECT_EQ(reaction().moved_by, FLINCH_MOVED_BY_CHARACTER);
  EXPECT_NEAR(pose().root_position[0], 3, 0.1);
  // Over a pose of the game's, with no weight, the body is where the game has it, and with all
  // weight where it is shown.
  ASSERT_EQ(flinch_character_react_to(character, &ball), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, kFrame_s), FLINCH_OK);
  flinch_mask mask = tests::half_of_everything();
  mask.weight = 1;
  flinch_pose game = pose();
  game.root_position[1] += 1;
  auto over = sized<flinch_pose>();
  ASSERT_EQ(flinch_character_pose_over(character, &game, &mask, &over), FLINCH_OK);
  EXPECT_NEAR(over.root_position[1], pose().root_position[1], 1e-6);
}

TEST_F(CApiReaction, BadInputIsRefusedAndChangesNothing) {
  flinch_threat ball = near_ball();
  refuses(FLINCH_NULL_POINTER, [&] { return flinch_character_react_to(character, nullptr); });
  ball.velocity[1] = kNan;
  refuses(FLINCH_BAD_THREAT, [&] { return flinch_character_react_to(character, &ball); });
  ball = near_ball();
  ball.size = 3;
  refuses(FLINCH_BAD_SIZE, [&] { return flinch_character_react_to(character, &ball); });
  ball = near_ball();
  ASSERT_EQ(flinch_character_react_to(character, &ball), FLINCH_OK);
  refuses(FLINCH_BAD_TIME, [&] { return flinch_character_update(character, 0.11F); });
  flinch_character* plain = nullptr;
  ASSERT_EQ(flinch_character_create(library, &plain), FLINCH_OK);
  auto out = sized<flinch_reaction>();
  EXPECT_EQ(flinch_character_react_to(plain, &ball), FLINCH_NOT_REACTING);
  EXPECT_EQ(flinch_character_reaction(plain, &out), FLINCH_NOT_REACTING);
  EXPECT_EQ(flinch_character_free(plain), FLINCH_OK);
  auto* made = reinterpret_cast<flinch_character*>(library);
  EXPECT_EQ(flinch_character_create_reacting(nullptr, &made), FLINCH_NULL_POINTER);
  EXPECT_EQ(made, nullptr);
}

TEST_F(CApiReaction, OutlinesAndMassesAreThoseOfTheFigure) {
  const motion::BodyModel expected = motion::make_body_model(motion::default_character());
  float mass_kg = 0;
  for (const motion::Body body : motion::kBodies) {
    auto outline = sized<flinch_outline>();
    const auto index = static_cast<std::int32_t>(body);
    ASSERT_EQ(flinch_library_outline(library, index, &outline), FLINCH_OK);
    EXPECT_EQ(flinch_body_name(index), motion::name_of(body));
    EXPECT_EQ(outline.joint, static_cast<std::int32_t>(role_of(body)));
    const motion::Shape& shape = expected[body].shape;
    EXPECT_EQ(outline.is_box == 1, shape.kind == motion::Shape::Kind::box);
    EXPECT_NEAR(outline.centre[2], shape.centre.z(), 1e-6);
    EXPECT_NEAR(outline.half_length, shape.half_length, 1e-6);
    EXPECT_NEAR(outline.half_extents[1], shape.half_extents.y(), 1e-6);
    mass_kg += outline.mass_kg;
  }
  auto info = sized<flinch_library_info>();
  ASSERT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  EXPECT_NEAR(mass_kg, info.mass_kg, 1e-3);
  auto outline = sized<flinch_outline>();
  EXPECT_EQ(flinch_library_outline(library, FLINCH_BODY_COUNT, &outline), FLINCH_BAD_INDEX);
  EXPECT_EQ(flinch_body_name(FLINCH_BODY_COUNT), nullptr);
}

}  // namespace
}  // namespace flinch::runtime
