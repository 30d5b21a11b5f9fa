// SPDX-License-Identifier: MIT
#include "reaction/crowd/crowd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "motion/rotation.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/push/push_scene.h"

namespace flinch::reaction {
namespace {

using motion::Role;

constexpr float kFrame_s = 1.0F / 60;

runtime::Library loaded(float realism) {
  tests::MadeUpSelector made =
      tests::made_up_selector(tests::library_with_walks(), 60, tests::ModelKind::knn);
  made.selector.realism = tests::constant_realism(realism);
  const std::string file = made.file();
  runtime::Library library;
  EXPECT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  return library;
}

/// Everyone who walks in the library, in a narrow square; where `realism` is low physics alone
/// answers.
struct CrowdScene {
  explicit CrowdScene(float realism = 0.9F) : library(loaded(realism)) {}
  Crowd crowd(CrowdOptions options = {.characters = 6, .half_side_m = 1.2F}) const {
    return {library, *graph, options};
  }
  runtime::Library library;
  std::shared_ptr<const runtime::MotionGraph> graph = runtime::make_motion_graph(library);
};

Eigen::Vector2f chest_of(const Crowd& crowd, const CrowdScene& scene, std::size_t one) {
  return motion::forward_kinematics(scene.library.clip_library().character.skeleton,
                                    crowd.characters()[one].pose())
      .position[Role::chest]
      .head<2>();
}

TEST(Crowd, TheSameSeedGivesTheSameBitsAndAnotherSeedOthers) {
  const CrowdScene scene;
  Crowd one = scene.crowd();
  Crowd twin = scene.crowd();
  Crowd other = scene.crowd({.characters = 6, .half_side_m = 1.2F, .seed = 2});
  bool differs = false;
  for (int frame = 0; frame < 600; ++frame) {
    for (Crowd* crowd : {&one, &twin, &other}) crowd->update(kFrame_s);
    for (std::size_t i = 0; i < 6; ++i) {
      const motion::Pose& pose = one.characters()[i].pose();
      ASSERT_TRUE(is_sound(pose)) << frame;
      ASSERT_EQ(pose.root_position, twin.characters()[i].pose().root_position) << frame;
      differs |= pose.root_position != other.characters()[i].pose().root_position;
    }
  }
  EXPECT_TRUE(differs);
  EXPECT_GT(one.tally().bumps, 0U);
  EXPECT_EQ(one.tally().answered, twin.tally().answered);
}

// Whoever is pushed is pushed away from another who is near, or from a wall; and has 0.6 s of rest.
TEST(Crowd, PushesLeadAwayFromTheOtherOrTheWallAndLeaveARest) {
  const CrowdScene scene;
  Crowd crowd = scene.crowd();
  const float wall_m = crowd.options().half_side_m - 0.24F;
  std::map<std::size_t, int> last;  // frame of each one's last push
  std::size_t from_others = 0;
  std::size_t from_walls = 0;
  std::size_t pushes = 0;
  for (int frame = 0; frame < 1800; ++frame) {
    crowd.update(kFrame_s);
    for (const CrowdPush& push : crowd.pushes()) {
      ++pushes;
      EXPECT_GE(push.velocity.norm(), 0.5F - 1e-5F);
      EXPECT_LE(push.velocity.norm(), 1.3F + 1e-5F);
      EXPECT_LT((push.at - chest_of(crowd, scene, push.character)).norm(), 1e-5F);
      const auto [before, is_first] = last.emplace(push.character, frame);
      EXPECT_TRUE(is_first || frame - before->second >= 35) << frame;
      before->second = frame;
      bool is_explained = false;
      for (std::size_t i = 0; i < crowd.characters().size() && !is_explained; ++i) {
        const Eigen::Vector2f away = push.at - chest_of(crowd, scene, i);
        if (i == push.character || away.norm() >= 0.48F) continue;
        is_explained = push.velocity.normalized().dot(away.normalized()) > 0.999F;
      }
      from_others += is_explained ? 1U : 0U;
      if (is_explained) continue;
      for (const int axis : {0, 1}) {
        const bool is_inward =
            push.velocity[axis] * push.at[axis] < 0 && std::abs(push.velocity[1 - axis]) < 1e-6F;
        is_explained |= is_inward && std::abs(push.at[axis]) > wall_m;
      }
      EXPECT_TRUE(is_explained) << frame << ": " << push.at.transpose() << ", "
                                << push.velocity.transpose();
      ++from_walls;
    }
  }
  EXPECT_GT(from_others, 20U);
  EXPECT_GT(from_walls, 2U);
  EXPECT_EQ(pushes, crowd.tally().answered + crowd.tally().physical);
}

// Two who stand in each other are pushed apart only while they come nearer.
TEST(Crowd, WhoMovesApartIsNotPushed) {
  const CrowdScene scene;
  Crowd crowd = scene.crowd();
  std::map<std::size_t, Eigen::Vector2f> before;
  int compared = 0;
  for (int frame = 0; frame < 1800; ++frame) {
    for (std::size_t i = 0; i < crowd.characters().size(); ++i)
      before[i] = chest_of(crowd, scene, i);
    crowd.update(kFrame_s);
    for (const CrowdPush& push : crowd.pushes()) {
      for (std::size_t i = 0; i < crowd.characters().size(); ++i) {
        const Eigen::Vector2f away = push.at - chest_of(crowd, scene, i);
        if (i == push.character || away.norm() >= 0.48F ||
            push.velocity.normalized().dot(away.normalized()) < 0.9999F)
          continue;
        EXPECT_LT(away.norm(), (before[push.character] - before[i]).norm()) << frame;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(Crowd, WithoutAGoodAnswerPhysicsTakesEveryPush) {
  const CrowdScene scene(0.4F);
  Crowd crowd = scene.crowd();
  for (int frame = 0; frame < 900; ++frame) {
    crowd.update(kFrame_s);
    for (const CrowdPush& push : crowd.pushes()) {
      EXPECT_TRUE(push.is_physical);
      EXPECT_EQ(crowd.characters()[push.character].pose_source(), PoseSource::physics);
    }
  }
  EXPECT_EQ(crowd.tally().answered, 0U);
  EXPECT_GT(crowd.tally().physical, 5U);
}

}  // namespace
}  // namespace flinch::reaction
