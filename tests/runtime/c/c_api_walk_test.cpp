// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "runtime/graph/motion_graph.h"
#include "tests/runtime/c/c_api_scene.h"
#include "tests/runtime/push/push_scene.h"

namespace flinch::runtime {
namespace {

using tests::sized;

constexpr float kWalkedFrame_s = 1.0F / 60;
constexpr std::int32_t kWalkersChest = static_cast<std::int32_t>(motion::Role::chest);

/// A library with everyday motion and pushes, all of whose responses have this realism.
std::string walking_file(float realism) {
  tests::MadeUpSelector made =
      tests::made_up_selector(tests::library_with_walks(), 40, tests::ModelKind::knn);
  made.selector.realism = tests::constant_realism(realism);
  return made.file();
}

class CApiWalk : public tests::CApi {
 protected:
  void SetUp() override {
    library = tests::load(walking_file(0.9F));
    ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
    ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
    ASSERT_EQ(flinch_motion_graph_create(library, &graph), FLINCH_OK);
  }
  void TearDown() override {
    flinch_motion_graph_free(graph);
    CApi::TearDown();
  }
  static flinch_pose pose_of(const flinch_character* of) {
    auto pose = sized<flinch_pose>();
    EXPECT_EQ(flinch_character_pose(of, &pose), FLINCH_OK);
    return pose;
  }
  static std::int32_t phase_of(const flinch_character* of) {
    auto state = sized<flinch_character_state>();
    EXPECT_EQ(flinch_character_describe(of, &state), FLINCH_OK);
    return state.phase;
  }

  flinch_motion_graph* graph = nullptr;
};

TEST_F(CApiWalk, IsTheWalkOfTheRunTime) {
  const std::string file = walking_file(0.9F);
  Library same;
  ASSERT_EQ(same.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  const auto same_graph = make_motion_graph(same);
  Character expected(same);
  Workspace expected_workspace;
  expected_workspace.reserve_memory(same.selection_bytes());
  ASSERT_EQ(expected.walk(*same_graph, 7, {{0.5F, 0}, 2}), Status::ok);
  ASSERT_EQ(flinch_character_walk(character, graph, 7, 0.5F, 0, 2), FLINCH_OK);
  EXPECT_EQ(phase_of(character), FLINCH_WALKING);
  bool was_pushed = false;
  for (int frame = 0; frame < 600; ++frame) {
    if (frame == 100) {
      const float velocity[3] = {-0.7F, 0.1F, 0};
      ASSERT_EQ(flinch_character_push(character, kWalkersChest, velocity, workspace), FLINCH_OK);
      ASSERT_EQ(expected.push(motion::Role::chest, {-0.7F, 0.1F, 0}, expected_workspace),
                Status::ok);
    }
    ASSERT_EQ(flinch_character_update(character, kWalkedFrame_s), FLINCH_OK);
    expected.update(kWalkedFrame_s);
    was_pushed = was_pushed || phase_of(character) == FLINCH_PUSHED;
    const flinch_pose pose = pose_of(character);
    const Eigen::Vector3f root = expected.pose().root_position;
    ASSERT_EQ(std::memcmp(pose.root_position, root.data(), sizeof pose.root_position), 0)
        << "frame " << frame;
  }
  EXPECT_TRUE(was_pushed);
  EXPECT_EQ(phase_of(character), FLINCH_WALKING);
}

TEST_F(CApiWalk, GoesOnWhenItsGraphIsFreedAlsoInACopy) {
  flinch_character* copy = nullptr;
  ASSERT_EQ(flinch_character_create(library, &copy), FLINCH_OK);
  ASSERT_EQ(flinch_character_walk(character, graph, 3, 0, 0, INFINITY), FLINCH_OK);
  ASSERT_EQ(flinch_character_copy(copy, character), FLINCH_OK);
  ASSERT_EQ(flinch_motion_graph_free(graph), FLINCH_OK);
  graph = nullptr;
  ASSERT_EQ(flinch_character_free(character), FLINCH_OK);
  character = copy;
  for (int frame = 0; frame < 400; ++frame) flinch_character_update(character, kWalkedFrame_s);
  EXPECT_EQ(phase_of(character), FLINCH_WALKING);
  EXPECT_TRUE(std::isfinite(pose_of(character).root_position[0]));
}

TEST_F(CApiWalk, ACharacterWithABodyIsMovedByPhysicsWhereNoResponseLooksReal) {
  flinch_library* bad = tests::load(walking_file(0.4F));
  flinch_workspace* its = nullptr;
  flinch_character* plain = nullptr;
  flinch_character* reacting = nullptr;
  ASSERT_EQ(flinch_workspace_create(bad, &its), FLINCH_OK);
  ASSERT_EQ(flinch_character_create(bad, &plain), FLINCH_OK);
  ASSERT_EQ(flinch_character_create_reacting(bad, &reacting), FLINCH_OK);
  const float velocity[3] = {-0.7F, 0, 0};
  EXPECT_EQ(flinch_character_push(plain, kWalkersChest, velocity, its), FLINCH_NO_GOOD_ANSWER);
  EXPECT_EQ(flinch_character_push(reacting, kWalkersChest, velocity, its), FLINCH_OK);
  auto reaction = sized<flinch_reaction>();
  ASSERT_EQ(flinch_character_reaction(reacting, &reaction), FLINCH_OK);
  EXPECT_EQ(reaction.phase, FLINCH_REACTION_STRUCK);
  const float x = pose_of(reacting).root_position[0];
  for (int frame = 0; frame < 6; ++frame) flinch_character_update(reacting, kWalkedFrame_s);
  EXPECT_LT(pose_of(reacting).root_position[0], x - 0.01F);
  flinch_character_free(reacting);
  flinch_character_free(plain);
  flinch_workspace_free(its);
  flinch_library_free(bad);
}

TEST_F(CApiWalk, RefusesBadArguments) {
  refuses(FLINCH_NULL_POINTER, [&] { return flinch_motion_graph_create(library, nullptr); });
  flinch_motion_graph* made = nullptr;
  refuses(FLINCH_NULL_POINTER, [&] { return flinch_motion_graph_create(nullptr, &made); });
  EXPECT_EQ(made, nullptr);
  refuses(FLINCH_NULL_POINTER,
          [&] { return flinch_character_walk(character, nullptr, 1, 0, 0, 3); });
  refuses(FLINCH_BAD_HANDLE, [&] {
    return flinch_character_walk(character, reinterpret_cast<flinch_motion_graph*>(library), 1, 0,
                                 0, 3);
  });
  flinch_library* other = tests::load(walking_file(0.9F));
  flinch_motion_graph* its = nullptr;
  ASSERT_EQ(flinch_motion_graph_create(other, &its), FLINCH_OK);
  refuses(FLINCH_OTHER_LIBRARY, [&] { return flinch_character_walk(character, its, 1, 0, 0, 3); });
  for (const float bad : {0.0F, -1.0F, tests::kNan})
    refuses(FLINCH_BAD_PLACEMENT,
            [&] { return flinch_character_walk(character, graph, 1, 0, 0, bad); });
  refuses(FLINCH_BAD_PLACEMENT,
          [&] { return flinch_character_walk(character, graph, 1, tests::kNan, 0, 3); });
  EXPECT_EQ(flinch_motion_graph_free(its), FLINCH_OK);
  EXPECT_EQ(flinch_motion_graph_free(nullptr), FLINCH_OK);
  flinch_library_free(other);
}

}  // namespace
}  // namespace flinch::runtime
