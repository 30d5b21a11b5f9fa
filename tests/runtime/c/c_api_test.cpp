// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include "runtime/character.h"
#include "tests/runtime/c/c_api_scene.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::runtime {
namespace {

using tests::ball;
using tests::CApi;
using tests::half_of_everything;
using tests::load;
using tests::selector_file;
using tests::sized;

bool is_same(const flinch_pose& c, const motion::Pose& ours) {
  bool same = Eigen::Vector3f(c.root_position) == ours.root_position;
  for (const motion::Role role : motion::kRoles) {
    const auto& q = c.rotation[static_cast<std::size_t>(role)];
    const Eigen::Quaternionf& rotation = ours.rotation[role];
    same = same && q[0] == rotation.w() && q[1] == rotation.x() && q[2] == rotation.y() &&
           q[3] == rotation.z();
  }
  return same;
}

TEST_F(CApi, MotionMatchesTheCxxApiBitForBit) {
  Library ours;
  ASSERT_EQ(ours.load(std::as_bytes(std::span(selector_file()))), database::LoadStatus::ok);
  Workspace our_workspace;
  ASSERT_EQ(our_workspace.reserve_memory(ours.selection_bytes()), database::LoadStatus::ok);
  Character twin(ours);
  twin.place({0.03F, -0.02F}, 0.4F, 1.1F);
  ASSERT_EQ(flinch_character_place(character, 0.03F, -0.02F, 0.4F, 1.1F), FLINCH_OK);

  const flinch_threat threat = ball();
  features::Threat same{.position = {8, 4, 1.5F}, .velocity = {-16, -8, 2.7F}};
  ASSERT_EQ(twin.perceive(same, our_workspace), Status::ok);
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  std::set<std::int32_t> phases;
  for (int frame = 0; frame < 200; ++frame) {
    const float dt_s = frame % 3 == 0 ? 0.031F : 0.008F;
    twin.update(dt_s);
    ASSERT_EQ(flinch_character_update(character, dt_s), FLINCH_OK);
    ASSERT_TRUE(is_same(pose(), twin.pose())) << frame;
    const flinch_character_state now = state();
    phases.insert(now.phase);
    EXPECT_EQ(now.phase, static_cast<int>(twin.phase()));
    EXPECT_STREQ(flinch_phase_name(now.phase), name_of(twin.phase()));
    EXPECT_EQ(now.clip, twin.clip());
    EXPECT_EQ(now.target, static_cast<int>(twin.target()));
    EXPECT_EQ(now.time_to_impact_s, twin.time_to_impact_s());
    EXPECT_EQ(now.position[0], twin.state().position.x());
    EXPECT_EQ(now.facing, twin.state().facing);
  }
  EXPECT_GE(phases.size(), 3U);

  flinch_candidate candidates[FLINCH_MOST_CANDIDATES];
  std::int32_t count = 0;
  ASSERT_EQ(flinch_character_candidates(character, candidates, FLINCH_MOST_CANDIDATES, &count),
            FLINCH_OK);
  ASSERT_EQ(static_cast<std::size_t>(count), twin.candidates().size());
  ASSERT_GT(count, 0);
  for (std::int32_t i = 0; i < count; ++i) {
    EXPECT_EQ(candidates[i].clip, twin.candidates()[static_cast<std::size_t>(i)].clip);
    EXPECT_EQ(candidates[i].vote, twin.candidates()[static_cast<std::size_t>(i)].vote);
    EXPECT_TRUE(std::isnan(candidates[i].expected_cost_ns));
  }
  EXPECT_EQ(flinch_character_candidates(character, candidates, 1, &count), FLINCH_OK);
  EXPECT_EQ(count, 1);
}

TEST_F(CApi, AnswersAKnownThreatWithTheSelectedClip) {
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace),
            FLINCH_OK);
  EXPECT_EQ(state().target, FLINCH_HEAD);
  EXPECT_FLOAT_EQ(state().time_to_impact_s, 0.5F);
  ASSERT_EQ(flinch_character_respond(character, 7, 0.4F), FLINCH_OK);
  EXPECT_EQ(state().clip, 7);
  EXPECT_FLOAT_EQ(state().time_to_impact_s, 0.4F);
  ASSERT_EQ(flinch_character_settle(character), FLINCH_OK);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(flinch_character_update(character, 0.02F), FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_IDLE);
}

TEST_F(CApi, StandsOnGuardAndBraces) {
  const database::ClipLibrary authored = database::authored_library(motion::default_character());
  const std::int32_t guard = flinch_library_stance(library, 1);
  ASSERT_GE(guard, 0);
  EXPECT_EQ(authored.clip(guard).name, "guard");
  EXPECT_EQ(flinch_library_stance(library, 2), -1);
  EXPECT_EQ(flinch_library_stance(nullptr, 0), -1);
  EXPECT_EQ(flinch_character_place_in_stance(character, 0, 0, 0, 0, 2), FLINCH_BAD_PLACEMENT);
  const flinch_pose idle = pose();
  ASSERT_EQ(flinch_character_place_in_stance(character, 0, 0, 0, 0, 1), FLINCH_OK);
  EXPECT_NE(pose().root_position[2], idle.root_position[2]);
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_brace(character, &threat, 1), FLINCH_OK);
  EXPECT_EQ(state().clip, -1);
  ASSERT_EQ(flinch_character_change_stance(character, 0), FLINCH_OK);
  EXPECT_EQ(flinch_character_change_stance(character, 7), FLINCH_BAD_PLACEMENT);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(flinch_character_update(character, 0.02F), FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_IDLE);
}

TEST_F(CApi, LibraryDescriptionMatchesTheFile) {
  const database::ClipLibrary authored = database::authored_library(motion::default_character());
  auto info = sized<flinch_library_info>();
  ASSERT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  ASSERT_EQ(static_cast<std::size_t>(info.clip_count), authored.clips.size());
  EXPECT_EQ(info.idle_clip, authored.idle);
  EXPECT_EQ(info.rate_hz, authored.rate_hz);
  EXPECT_EQ(info.mass_kg, authored.character.mass_kg);
  for (std::int32_t i = 0; i < info.clip_count; ++i) {
    const motion::Clip& ours = authored.clip(i);
    auto clip = sized<flinch_clip>();
    ASSERT_EQ(flinch_library_clip(library, i, &clip), FLINCH_OK);
    EXPECT_EQ(clip.name, ours.name);
    EXPECT_EQ(clip.kind, ours.kind);
    EXPECT_EQ(clip.duration_s, ours.motion.duration_s());
    ASSERT_EQ(clip.is_annotated != 0, ours.annotation.has_value());
    if (!ours.annotation) continue;
    EXPECT_EQ(flinch_target_name(clip.target), name_of(ours.annotation->target));
    EXPECT_EQ(clip.direction, ours.annotation->direction);
    EXPECT_EQ(clip.degree, static_cast<int>(ours.annotation->degree));
    EXPECT_EQ(clip.onset_s, ours.annotation->onset_s);
    EXPECT_EQ(clip.peak_s, ours.annotation->peak_s);
    EXPECT_EQ(clip.end_s, ours.annotation->end_s);
  }
}

// Repeats the forward kinematics, with the skeleton as the C interface returns it.
TEST_F(CApi, JointFramesMatchForwardKinematics) {
  auto skeleton = sized<flinch_skeleton>();
  auto frames = sized<flinch_joint_frames>();
  ASSERT_EQ(flinch_library_skeleton(library, &skeleton), FLINCH_OK);
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.4F), FLINCH_OK);
  const flinch_pose now = pose();
  ASSERT_EQ(flinch_library_joint_frames(library, &now, &frames), FLINCH_OK);
  std::array<Eigen::Affine3f, FLINCH_JOINT_COUNT> world;
  for (std::int32_t joint = 0; joint < FLINCH_JOINT_COUNT; ++joint) {
    const std::int32_t parent = flinch_joint_parent(joint);
    ASSERT_LT(parent, joint) << "parents come first";
    const float(&q)[4] = now.rotation[joint];
    const Eigen::Vector3f offset(parent < 0 ? now.root_position : skeleton.offset[joint]);
    const Eigen::Affine3f local =
        Eigen::Translation3f(offset) * Eigen::Quaternionf(q[0], q[1], q[2], q[3]);
    world[static_cast<std::size_t>(joint)] =
        parent < 0 ? local : world[static_cast<std::size_t>(parent)] * local;
    const Eigen::Vector3f position(frames.position[joint]);
    EXPECT_LT((position - world[static_cast<std::size_t>(joint)].translation()).norm(), 1e-5F)
        << flinch_joint_name(joint);
  }
}

TEST_F(CApi, PoseOverBlendsByTheMask) {
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.4F), FLINCH_OK);
  auto game = sized<flinch_pose>();
  for (auto& rotation : game.rotation) rotation[0] = 1;
  flinch_mask mask = half_of_everything();
  mask.weight = 1;
  mask.joint[12] = 0;  // the game keeps the right hand
  flinch_pose over = game;
  ASSERT_EQ(flinch_character_pose_over(character, &game, &mask, &over), FLINCH_OK);
  const flinch_pose whole = pose();
  for (std::size_t joint = 0; joint < FLINCH_JOINT_COUNT; ++joint) {
    const Eigen::Vector4f expected(joint == 12 ? game.rotation[joint] : whole.rotation[joint]);
    EXPECT_NEAR(std::abs(expected.dot(Eigen::Vector4f(over.rotation[joint]))), 1, 1e-5) << joint;
  }
  EXPECT_NEAR(over.root_position[2], whole.root_position[2], 1e-6);
  // In place: the output is also an input.
  ASSERT_EQ(flinch_character_pose_over(character, &game, &mask, &game), FLINCH_OK);
  EXPECT_EQ(std::memcmp(&game, &over, sizeof game), 0);
}

TEST_F(CApi, HumanLimitsDelayTheResponse) {
  auto limits = sized<flinch_perception_limits>();
  ASSERT_EQ(flinch_human_limits(1, &limits), FLINCH_OK);
  EXPECT_GT(limits.reaction_delay_s, 0.1F);
  limits.chance_to_fail = 0;
  ASSERT_EQ(flinch_character_limit_perception(character, &limits, 3), FLINCH_OK);
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace),
            FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_REACTING);
  limits.chance_to_fail = 1;
  ASSERT_EQ(flinch_character_limit_perception(character, &limits, 3), FLINCH_OK);
  EXPECT_EQ(perceive(threat), FLINCH_UNNOTICED);
}

TEST_F(CApi, NamesMatchTheCxxApi) {
  for (const motion::Role role : motion::kRoles) {
    const auto joint = static_cast<std::int32_t>(role);
    EXPECT_EQ(flinch_joint_name(joint), motion::name_of(role));
    const auto parent = motion::parent_of(role);
    EXPECT_EQ(flinch_joint_parent(joint), parent ? static_cast<int>(*parent) : -1);
  }
  EXPECT_STREQ(flinch_target_name(FLINCH_TRUNK), "trunk");
  EXPECT_STREQ(flinch_phase_name(FLINCH_IDLE), "idle");
  EXPECT_STREQ(flinch_phase_name(FLINCH_RETURNING), "returning");
  EXPECT_STREQ(flinch_phase_name(FLINCH_WALKING), "walking");
}

TEST_F(CApi, AllocatesNothingButHandles) {
  const flinch_threat threat = ball();
  const flinch_mask mask = half_of_everything();
  auto frames = sized<flinch_joint_frames>();
  flinch_pose now = pose();
  const std::size_t before = tests::allocation_count();
  for (int frame = 0; frame < 300; ++frame) {
    if (frame % 50 == 10) flinch_character_perceive(character, &threat, workspace);
    if (frame % 100 == 90) flinch_character_set_pose(character, &now, &now, 0.01F);
    flinch_character_update(character, 0.01F);
    flinch_character_pose(character, &now);
    flinch_character_pose_over(character, &now, &mask, &now);
    flinch_library_joint_frames(library, &now, &frames);
    state();
  }
  EXPECT_EQ(tests::allocation_count(), before);
}

}  // namespace
}  // namespace flinch::runtime
