// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/character.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"

namespace flinch::runtime {
namespace {

using motion::Role;

Library loaded_with(const database::ClipLibrary& clips,
                    std::optional<models::RealismModel> realism) {
  tests::MadeUpSelector made = tests::made_up_selector(clips, 40, tests::ModelKind::knn);
  made.selector.realism = std::move(realism);
  const std::string file = made.file();
  Library library;
  EXPECT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  return library;
}

const Library& pushable() {
  static const Library one =
      loaded_with(tests::library_with_pushes(), tests::constant_realism(0.9F));
  return one;
}

struct PushedOne {
  explicit PushedOne(const Library& of) : character(of) {
    workspace.reserve_memory(of.selection_bytes());
    character.place({1, 2}, 0.5F, 0.3F);
  }
  Status push(Role place, const Eigen::Vector3f& velocity) {
    return character.push(place, velocity, workspace);
  }
  Character character;
  Workspace workspace;
};

constexpr float kPushFrame_s = 1.0F / 60;

TEST(CharacterPush, WithThePapersFPlaysWhatThatSays) {
  models::RealismModel realism = tests::constant_realism(1);
  models::ThetaExamples& theta = realism.theta.emplace();
  theta.weight.fill(1);
  theta.points.assign(realism.size() * models::kImpulseFeatureCount, 0);
  for (std::size_t i = 0; i < realism.size(); ++i)
    theta.theta.insert(theta.theta.end(), {std::log(5.0F), 0.1F, -0.2F, 0});
  const Library library = loaded_with(tests::library_with_pushes(), realism);
  const auto played = [](const Library& of, const Eigen::Vector3f& velocity) {
    PushedOne one(of);
    EXPECT_EQ(one.push(Role::chest, velocity), Status::ok);
    one.character.update(0.3F);
    return one.character.pose();
  };
  // All examples have the same theta: two pushes look alike. The exact F tells them apart.
  const Eigen::Vector3f one(0.9F, 0, 0);
  const Eigen::Vector3f other(0.3F, 0.5F, 0);
  EXPECT_EQ(tests::distance(played(library, one), played(library, other)), 0);
  EXPECT_GT(tests::distance(played(pushable(), one), played(pushable(), other)), 0.01F);
  PushedOne pushed(library);
  ASSERT_EQ(pushed.push(Role::chest, one), Status::ok);
  for (const PushCandidate& candidate : pushed.character.push_candidates()) {
    EXPECT_NEAR(candidate.taper, 5, 1e-4F);
    EXPECT_LT((candidate.deformation - Eigen::Vector3f(0.1F, -0.2F, 0)).norm(), 1e-5F);
    EXPECT_EQ(candidate.turn, 0);
  }
}

TEST(CharacterPush, AnswersAndReturnsToIdleWithoutAJump) {
  PushedOne one(pushable());
  for (int k = 0; k < 30; ++k) one.character.update(kPushFrame_s);
  const motion::Pose before = one.character.pose();
  ASSERT_EQ(one.push(Role::left_upper_arm, {0.5F, 0.6F, 0}), Status::ok);
  EXPECT_LT(tests::distance(one.character.pose(), before), 2e-3F);
  EXPECT_EQ(one.character.phase(), Phase::pushed);
  EXPECT_TRUE(pushable().clip_library().clip(one.character.clip()).push);
  EXPECT_EQ(one.character.push_candidates().size(), 6U);
  EXPECT_NEAR(one.character.push_candidates()[0].realism, 0.9F, 1e-5F);
  motion::Pose last = one.character.pose();
  int frames = 0;
  for (; one.character.phase() != Phase::idle && frames < 600; ++frames) {
    one.character.update(kPushFrame_s);
    const motion::Pose pose = one.character.pose();
    ASSERT_TRUE(is_sound(pose));
    ASSERT_LT(tests::distance(pose, last), 0.25F) << frames;
    last = pose;
  }
  EXPECT_GT(frames, 60);
  EXPECT_LT(frames, 600);
  EXPECT_GT((last.root_position - before.root_position).head<2>().norm(), 0.1F);
}

TEST(CharacterPush, TakesAnotherPushDuringTheFirst) {
  PushedOne one(pushable());
  ASSERT_EQ(one.push(Role::chest, {-1, 0, 0}), Status::ok);
  for (int k = 0; k < 24; ++k) one.character.update(kPushFrame_s);
  const motion::Pose before = one.character.pose();
  int answered = 0;
  for (int k = 0; k < 16; ++k) {
    const float direction = static_cast<float>(k) * 0.4F;
    Character again = one.character;
    if (again.push(Role::chest, {1.1F * std::cos(direction), 1.1F * std::sin(direction), 0},
                   one.workspace) != Status::ok) {
      continue;
    }
    ++answered;
    EXPECT_LT(tests::distance(again.pose(), before), 5e-3F);
    again.update(kPushFrame_s);
    EXPECT_LT(tests::distance(again.pose(), before), 0.2F);
  }
  EXPECT_GT(answered, 2);
}

TEST(CharacterPush, IsTheSameAtAnyFrameRate) {
  PushedOne slow(pushable());
  PushedOne fast(pushable());
  slow.push(Role::chest, {0.8F, 0.2F, 0});
  fast.push(Role::chest, {0.8F, 0.2F, 0});
  for (int k = 0; k < 15; ++k) slow.character.update(1.0F / 30);
  for (int k = 0; k < 60; ++k) fast.character.update(1.0F / 120);
  EXPECT_LT(tests::distance(slow.character.pose(), fast.character.pose()), 1e-3F);
}

TEST(CharacterPush, SaysWhyItDoesNotAnswerAndChangesNothing) {
  PushedOne one(pushable());
  const motion::Pose before = one.character.pose();
  for (const Eigen::Vector3f& velocity :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0.01F, 0, 0), Eigen::Vector3f(0, 21, 0),
        Eigen::Vector3f(tests::kNan, 0, 0), Eigen::Vector3f(0, tests::kInfinity, 0)}) {
    EXPECT_EQ(one.push(Role::chest, velocity), Status::bad_push);
  }
  EXPECT_EQ(one.push(Role::left_foot, {1, 0, 0}), Status::bad_push);
  EXPECT_EQ(one.push(Role{99}, {1, 0, 0}), Status::bad_push);
  EXPECT_EQ(tests::distance(one.character.pose(), before), 0);

  const Library no_pushes = loaded_with(scenes::synthetic_library(), tests::constant_realism(0.9F));
  EXPECT_EQ(PushedOne(no_pushes).push(Role::chest, {1, 0, 0}), Status::without_pushes);
  const Library no_realism = loaded_with(tests::library_with_pushes(), std::nullopt);
  EXPECT_EQ(PushedOne(no_realism).push(Role::chest, {1, 0, 0}), Status::without_realism);
  const Library bad = loaded_with(tests::library_with_pushes(), tests::constant_realism(0.4F));
  PushedOne refused(bad);
  EXPECT_EQ(refused.push(Role::chest, {1, 0, 0}), Status::no_good_answer);
  EXPECT_EQ(refused.character.phase(), Phase::idle);
  EXPECT_NEAR(refused.character.push_candidates()[0].realism, 0.4F, 1e-5F);
  PushedOne small(pushable());
  Workspace none;
  EXPECT_EQ(small.character.push(Role::chest, {1, 0, 0}, none), Status::other_workspace);
}

TEST(CharacterPush, AllocatesNothing) {
  PushedOne one(pushable());
  const std::size_t before = tests::allocation_count();
  for (int k = 0; k < 100; ++k) {
    if (k % 40 == 0) one.push(Role::chest, {0.7F, 0.1F, 0});
    one.character.update(kPushFrame_s);
    one.character.pose();
  }
  EXPECT_EQ(tests::allocation_count(), before);
}

}  // namespace
}  // namespace flinch::runtime
