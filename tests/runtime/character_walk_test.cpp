// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "runtime/character.h"
#include "runtime/graph/motion_graph.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::runtime {
namespace {

using motion::Role;

constexpr float kWalkFrame_s = 1.0F / 60;

Library walkable() {
  tests::MadeUpSelector made =
      tests::made_up_selector(tests::library_with_walks(), 40, tests::ModelKind::knn);
  made.selector.realism = tests::constant_realism(0.9F);
  const std::string file = made.file();
  Library library;
  EXPECT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  return library;
}

struct Walker {
  Library library = walkable();
  std::shared_ptr<const MotionGraph> graph = make_motion_graph(library);
  Workspace workspace;
  Walker() { workspace.reserve_memory(library.selection_bytes()); }
  Character walking(std::uint64_t seed) const {
    Character character(library);
    character.place({1, 2}, 0.5F, 0.3F);
    EXPECT_EQ(character.walk(*graph, seed), Status::ok);
    return character;
  }
};

const Walker& walker() {
  static const Walker one;
  return one;
}

TEST(CharacterWalk, GoesThroughTheClipsWithoutAJump) {
  Character character = walker().walking(1);
  std::set<int> clips;
  motion::Pose last = character.pose();
  for (int k = 0; k < 60 * 60; ++k) {
    ASSERT_EQ(character.update(kWalkFrame_s), Status::ok);
    ASSERT_EQ(character.phase(), Phase::walking);
    clips.insert(character.clip());
    const motion::Pose pose = character.pose();
    ASSERT_TRUE(is_sound(pose));
    ASSERT_LT(tests::distance(pose, last), 0.2F) << k;
    last = pose;
  }
  EXPECT_EQ(clips.size(), 3U);
}

TEST(CharacterWalk, IsDecidedByItsSeed) {
  const auto places = [](std::uint64_t seed) {
    Character character = walker().walking(seed);
    std::vector<float> all;
    for (int k = 0; k < 1200; ++k) {
      character.update(kWalkFrame_s);
      all.push_back(character.pose().root_position.x());
    }
    return all;
  };
  EXPECT_EQ(places(3), places(3));
  EXPECT_NE(places(3), places(4));
}

TEST(CharacterWalk, IsNearlyTheSameAtAnyFrameRate) {
  Character slow = walker().walking(5);
  Character fast = walker().walking(5);
  // Jumps come at whole frames of the clips: a quarter of one later, rounding decides none of them.
  for (Character* character : {&slow, &fast}) character->update(kWalkFrame_s / 4);
  for (int second = 0; second < 20; ++second) {
    for (int k = 0; k < 12; ++k) slow.update(1.0F / 12);
    for (int k = 0; k < 120; ++k) fast.update(1.0F / 120);
    EXPECT_EQ(slow.clip(), fast.clip()) << second;
    EXPECT_LT(tests::distance(slow.pose(), fast.pose()), 0.01F) << second;
  }
}

TEST(CharacterWalk, AnswersAPushAndWalksOn) {
  Character character = walker().walking(1);
  Workspace workspace;
  workspace.reserve_memory(walker().library.selection_bytes());
  int answered = 0;
  for (int round = 0; round < 12; ++round) {
    for (int k = 0; k < 100; ++k) character.update(kWalkFrame_s);
    const motion::Pose before = character.pose();
    const float direction = static_cast<float>(round);
    if (character.push(Role::chest, {std::cos(direction), std::sin(direction), 0}, workspace) !=
        Status::ok)
      continue;
    ++answered;
    EXPECT_EQ(character.phase(), Phase::pushed);
    EXPECT_LT(tests::distance(character.pose(), before), 5e-3F);
    const int response = character.clip();
    motion::Pose last = character.pose();
    int frames = 0;
    for (; frames < 300 && character.phase() != Phase::walking; ++frames) {
      character.update(kWalkFrame_s);
      ASSERT_LT(tests::distance(character.pose(), last), 0.25F) << round << ' ' << frames;
      last = character.pose();
    }
    const GraphExit& exit = walker().graph->exits[static_cast<std::size_t>(response)];
    const float contact_s = walker().library.clip_library().clip(response).push->contact_s;
    EXPECT_NEAR(static_cast<float>(frames), 60 * (exit.leave_s - contact_s), 2) << round;
  }
  EXPECT_GT(answered, 4);
}

TEST(CharacterWalk, AnswersAThreatAndWalksOn) {
  Character character = walker().walking(2);
  for (int k = 0; k < 40; ++k) character.update(kWalkFrame_s);
  const motion::Pose before = character.pose();
  ASSERT_EQ(character.respond(1, 0.6F), Status::ok);
  EXPECT_LT(tests::distance(character.pose(), before), 5e-3F);
  EXPECT_NE(character.phase(), Phase::walking);
  int frames = 0;
  for (; frames < 600 && character.phase() != Phase::walking; ++frames)
    character.update(kWalkFrame_s);
  EXPECT_GT(frames, 30);
  EXPECT_LT(frames, 600);
}

TEST(CharacterWalk, EndsWhenTheCharacterSettlesOrTheGameMovesIt) {
  Character character = walker().walking(2);
  for (int k = 0; k < 90; ++k) character.update(kWalkFrame_s);
  Character animated = character;
  animated.set_pose(character.pose(), character.pose(), kWalkFrame_s);
  const motion::Pose before = character.pose();
  ASSERT_EQ(character.settle(), Status::ok);
  EXPECT_LT(tests::distance(character.pose(), before), 5e-3F);
  for (int k = 0; k < 300; ++k) {
    character.update(kWalkFrame_s);
    animated.update(kWalkFrame_s);
  }
  EXPECT_EQ(character.phase(), Phase::idle);
  EXPECT_EQ(animated.phase(), Phase::idle);
}

float farthest_m(Character character, const Eigen::Vector2f& centre) {
  float farthest = 0;
  for (int k = 0; k < 180 * 60; ++k) {
    character.update(kWalkFrame_s);
    farthest = std::max(farthest, (character.pose().root_position.head<2>() - centre).norm());
  }
  return farthest;
}

TEST(CharacterWalk, KeepsToItsArea) {
  const Eigen::Vector2f centre(0.8F, 1.9F);
  Character bounded = walker().walking(1);
  ASSERT_EQ(bounded.walk(*walker().graph, 1, {centre, 1.2F}), Status::ok);
  EXPECT_LT(farthest_m(bounded, centre), 1.2F);
  EXPECT_GT(farthest_m(walker().walking(1), centre), 3);
  EXPECT_EQ(bounded.walk(*walker().graph, 1, {centre, 0}), Status::bad_placement);
  EXPECT_EQ(bounded.walk(*walker().graph, 1, {{std::nanf(""), 0}, 1}), Status::bad_placement);
}

TEST(CharacterWalk, GoesOnFromWhereItWasMoved) {
  Character character = walker().walking(1);
  for (int k = 0; k < 100; ++k) character.update(kWalkFrame_s);
  const motion::Pose moved = motion::placed(character.pose(), 0.5F, {3, 0, 0});
  ASSERT_EQ(character.move_to(moved, moved, kWalkFrame_s), Status::ok);
  EXPECT_TRUE(character.walks());
  EXPECT_LT(tests::distance(character.pose(), moved), 1e-3F);
  character.update(kWalkFrame_s);
  EXPECT_EQ(character.phase(), Phase::walking);
  EXPECT_LT(tests::distance(character.pose(), moved), 0.1F);
}

TEST(CharacterWalk, RefusesTheGraphOfAnotherLibraryAndSurvivesALongFrame) {
  const Library other = walkable();
  Character character(other);
  EXPECT_EQ(character.walk(*walker().graph, 1), Status::not_loaded);
  EXPECT_EQ(character.phase(), Phase::idle);
  EXPECT_EQ(make_motion_graph(Library()), nullptr);
  Character patient = walker().walking(1);
  EXPECT_EQ(patient.update(1e6F), Status::ok);
  EXPECT_TRUE(is_sound(patient.pose()));
}

TEST(CharacterWalk, AllocatesNothing) {
  Character character = walker().walking(1);
  const std::size_t before = tests::allocation_count();
  for (int k = 0; k < 1000; ++k) character.update(kWalkFrame_s);
  EXPECT_EQ(tests::allocation_count(), before);
}

}  // namespace
}  // namespace flinch::runtime
