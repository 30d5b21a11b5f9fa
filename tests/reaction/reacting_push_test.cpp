// SPDX-License-Identifier: MIT
// Characters with a physical body that are pushed.
#include <gtest/gtest.h>

#include <cmath>

#include "motion/rotation.h"
#include "reaction/reacting_character.h"
#include "runtime/graph/motion_graph.h"
#include "tests/reaction/reaction_player.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"

namespace flinch::reaction {
namespace {

using motion::Role;
using runtime::Status;
using scenes::same_bits;

constexpr float kPushedFrame_s = 1.0F / 60;

runtime::Library loaded(std::optional<float> realism) {
  tests::MadeUpSelector made =
      tests::made_up_selector(tests::library_with_walks(), 60, tests::ModelKind::knn);
  if (realism) made.selector.realism = tests::constant_realism(*realism);
  const std::string file = made.file();
  runtime::Library library;
  EXPECT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  return library;
}
const runtime::Library& good() {
  static const runtime::Library library = loaded(0.9F);
  return library;
}
/// Whose responses never look real.
const runtime::Library& bad() {
  static const runtime::Library library = loaded(0.4F);
  return library;
}

ReactingCharacter standing(const runtime::Library& library) {
  ReactingCharacter character(library, make_reaction_data(library));
  for (int frame = 0; frame < 10; ++frame) character.update(kPushedFrame_s);
  return character;
}

Eigen::Vector3f chest_of(const motion::Pose& pose) {
  return scenes::frames_of(pose).position[Role::chest];
}

std::vector<motion::Pose> play(ReactingCharacter& character, float duration_s) {
  std::vector<motion::Pose> poses{character.pose()};
  for (float time_s = 0; time_s < duration_s; time_s += kPushedFrame_s) {
    EXPECT_EQ(character.update(kPushedFrame_s), ReactionStatus::ok);
    poses.push_back(character.pose());
  }
  return poses;
}

TEST(ReactingPush, WithAGoodAnswerIsThatOfTheRunTime) {
  ReactingCharacter one = standing(good());
  runtime::Character twin = one.character();
  runtime::Workspace workspace;
  workspace.reserve_memory(good().selection_bytes());
  ASSERT_EQ(one.push(Role::chest, {-0.8F, 0.1F, 0}), Status::ok);
  ASSERT_EQ(twin.push(Role::chest, {-0.8F, 0.1F, 0}, workspace), Status::ok);
  for (int frame = 0; frame < 200; ++frame) {
    one.update(kPushedFrame_s);
    twin.update(kPushedFrame_s);
    ASSERT_TRUE(same_bits(one.pose(), twin.pose())) << "frame " << frame;
  }
}

TEST(ReactingPush, WithoutAGoodAnswerPhysicsMovesTheBodyAlongThePush) {
  for (const Eigen::Vector3f& velocity : {Eigen::Vector3f(-0.8F, 0, 0), Eigen::Vector3f(0, 0.8F, 0),
                                          Eigen::Vector3f(0.5F, -0.5F, 0)}) {
    ReactingCharacter one = standing(bad());
    ASSERT_EQ(one.push(Role::chest, velocity), Status::ok);
    EXPECT_EQ(one.pose_source(), PoseSource::physics);
    EXPECT_EQ(one.reaction().phase(), ReactionPhase::struck);
    EXPECT_EQ(one.reaction().contact_s(), 0);
    const motion::Pose start = one.pose();
    const auto poses = play(one, 4);
    // In the first frame the chest has nearly the asked velocity: its joints spread it over the
    // body.
    const auto moved = [&](std::size_t frame) {
      return (chest_of(poses[frame]) - chest_of(start)).dot(velocity.normalized());
    };
    EXPECT_NEAR(moved(1), kPushedFrame_s * velocity.norm(),
                0.3F * kPushedFrame_s * velocity.norm());
    EXPECT_GT(moved(6), 0.03F * velocity.norm());
    // Its feet have stood, so it comes back to where they are.
    EXPECT_EQ(one.pose_source(), PoseSource::character);
    EXPECT_EQ(one.character().phase(), runtime::Phase::idle);
    EXPECT_LT(std::abs(moved(poses.size() - 1)), 0.02F);
  }
}

TEST(ReactingPush, LimitsOfPerceptionOutlastTheRecovery) {
  ReactingCharacter one = standing(bad());
  ASSERT_EQ(one.push(Role::chest, {-0.8F, 0, 0}), Status::ok);
  play(one, 0.6F);
  ASSERT_EQ(one.pose_source(), PoseSource::physics);
  runtime::PerceptionLimits blind;
  blind.chance_to_fail = 1;
  one.character().limit_perception(blind, 5);
  play(one, 3);
  ASSERT_EQ(one.pose_source(), PoseSource::character);
  runtime::Workspace workspace;
  workspace.reserve_memory(bad().selection_bytes());
  features::Threat ball;
  ball.position = {5, 0, 1.6F};
  ball.velocity = {-10, 0, 2};
  EXPECT_EQ(one.character().perceive(ball, motion::Target::head, 0.5F, workspace),
            Status::unnoticed);
}

TEST(ReactingPush, APushByPhysicsIsContinuous) {
  ReactingCharacter one = standing(bad());
  const motion::Pose before = one.pose();
  ASSERT_EQ(one.push(Role::left_upper_arm, {0.2F, -0.6F, 0}), Status::ok);
  EXPECT_TRUE(same_bits(one.pose(), before));
  const auto poses = play(one, 4);
  for (std::size_t k = 1; k < poses.size(); ++k)  // 6 cm in a frame are 3.6 m/s
    EXPECT_LT(scenes::distance(poses[k - 1], poses[k]), 0.06) << "frame " << k;
}

TEST(ReactingPush, AStrongPushKnocksOverAndWhoLiesIsNotPushedAgain) {
  ReactingCharacter one = standing(bad());
  ASSERT_EQ(one.push(Role::chest, {-3.5F, 0, 0}), Status::ok);
  const auto poses = play(one, 2);
  EXPECT_EQ(one.reaction().phase(), ReactionPhase::knocked_over);
  EXPECT_LT(poses.back().root_position.z(), 0.5F);
  EXPECT_EQ(one.push(Role::chest, {1, 0, 0}), Status::no_good_answer);
  EXPECT_EQ(one.reaction().phase(), ReactionPhase::knocked_over);
}

TEST(ReactingPush, WithoutPushesOrRealismPhysicsAnswersToo) {
  static const runtime::Library without = loaded(std::nullopt);
  ReactingCharacter one = standing(without);
  EXPECT_EQ(one.push(Role::head, {0.6F, 0, 0}), Status::ok);
  EXPECT_EQ(one.pose_source(), PoseSource::physics);
  ReactingCharacter bodiless(bad(), nullptr);
  EXPECT_EQ(bodiless.push(Role::chest, {0.6F, 0, 0}), Status::no_good_answer);
}

TEST(ReactingPush, APushDuringPhysicsIsAnsweredFromTheShownPose) {
  ReactingCharacter one = standing(good());
  features::Ball ball = scenes::aimed_ball(chest_of(one.pose()).cast<double>(), {-14, 2, 0}, 0.05);
  ASSERT_EQ(one.react_to(ball), ReactionStatus::ok);
  play(one, 0.1F);
  ASSERT_EQ(one.pose_source(), PoseSource::physics);
  const motion::Pose before = one.pose();
  ASSERT_EQ(one.push(Role::chest, {0.7F, 0, 0}), Status::ok);
  EXPECT_EQ(one.pose_source(), PoseSource::reaction_clip);
  one.update(kPushedFrame_s);
  EXPECT_LT(scenes::distance(one.pose(), before), 0.05);
}

TEST(ReactingPush, AWalkerWalksOnFromWhereItWasPushed) {
  const auto graph = runtime::make_motion_graph(bad());
  ASSERT_TRUE(graph);
  ReactingCharacter one = standing(bad());
  ASSERT_EQ(one.character().walk(*graph, 3), Status::ok);
  play(one, 1);
  ASSERT_EQ(one.push(Role::chest, {0.5F, 0.4F, 0}), Status::ok);
  play(one, 2);
  EXPECT_EQ(one.pose_source(), PoseSource::character);
  EXPECT_EQ(one.character().phase(), runtime::Phase::walking);
}

TEST(ReactingPush, BadPushesChangeNothing) {
  ReactingCharacter one = standing(bad());
  const motion::Pose before = one.pose();
  EXPECT_EQ(one.push(Role::left_foot, {1, 0, 0}), Status::bad_push);
  EXPECT_EQ(one.push(Role::chest, {0, 0, 0}), Status::bad_push);
  EXPECT_EQ(one.push(Role::chest, {tests::kNan, 0, 0}), Status::bad_push);
  EXPECT_EQ(one.pose_source(), PoseSource::character);
  EXPECT_TRUE(same_bits(one.pose(), before));

  Reaction reaction(make_reaction_data(bad())->figure);
  EXPECT_EQ(reaction.begin_push(before, before, 1 / 60.0, Role::left_foot, {1, 0, 0}),
            ReactionStatus::bad_push);
  EXPECT_EQ(reaction.begin_push(before, before, 1 / 60.0, Role::chest, {tests::kNanDouble, 0, 0}),
            ReactionStatus::bad_push);
  EXPECT_EQ(reaction.phase(), ReactionPhase::none);
}

TEST(ReactingPush, AllocatesNothingOnceItHasBegun) {
  for (const runtime::Library* library : {&good(), &bad()}) {
    ReactingCharacter one = standing(*library);
    ASSERT_EQ(one.push(Role::chest, {-0.7F, 0, 0}), Status::ok);
    const std::size_t allocations = tests::allocation_count();
    for (int frame = 0; frame < 200; ++frame) one.update(kPushedFrame_s);
    EXPECT_EQ(tests::allocation_count(), allocations);
  }
}

}  // namespace
}  // namespace flinch::reaction
