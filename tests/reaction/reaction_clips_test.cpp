// SPDX-License-Identifier: MIT
#include "reaction/reaction_clips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scenes/not_finite.h"
#include "tests/sim/figure_motions.h"

namespace flinch::reaction {
namespace {

constexpr float kBetweenPoses_s = 1.0F / 60;

const motion::Physique& character() {
  static const motion::Physique man = motion::default_character();
  return man;
}

std::vector<motion::Clip> clips() {
  std::vector<motion::Clip> result;
  for (const auto& [name, motion] : scenes::motions_by_rule(character().skeleton)) {
    motion::Clip clip;
    clip.name = name;
    clip.purpose = motion::Purpose::push;
    clip.motion = motion;
    result.push_back(clip);
  }
  return result;
}

TEST(ReactionClips, MatchDoesNotDependOnPositionAndFacing) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  ASSERT_GT(index.size(), 100U);
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> uniform(-3, 3);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const float time_s = 0.3F;  // in the middle of the motion
    const float yaw = uniform(generator);
    const Eigen::Vector3f place(uniform(generator), uniform(generator), 0);
    const auto posed = [&](float at_s) {
      return motion::placed(sample(all[i].motion, at_s), yaw, place);
    };
    const auto match = index.find(posed(time_s - kBetweenPoses_s), posed(time_s), kBetweenPoses_s);
    ASSERT_TRUE(match) << all[i].name;
    // The two ducks are nearly the same motion.
    if (all[i].name != "squat" && all[i].name != "fast duck") {
      EXPECT_EQ(match->clip, static_cast<int>(i));
    }
    EXPECT_LT(match->distance_m, 0.02F) << all[i].name;
    const motion::Clip& found = all[static_cast<std::size_t>(match->clip)];
    const auto a = forward_kinematics(character().skeleton, pose_of(found, *match, 0));
    const auto b = forward_kinematics(character().skeleton, posed(time_s));
    for (motion::Role role : motion::kRoles) {
      EXPECT_LT((a.position[role] - b.position[role]).norm(), 0.06F) << all[i].name;
    }
  }
}

TEST(ReactionClips, DistanceMatchesItsFormula) {
  // One clip that stands still. The character stands in its pose but moves upwards.
  auto all = clips();
  all.resize(1);
  const ReactionClips index(character(), all);
  const motion::Pose standing = all[0].motion.poses.front();
  motion::Pose above = standing;
  above.root_position.z() += 0.03F;
  motion::Pose below = above;
  below.root_position.z() -= 0.4F * kBetweenPoses_s;
  const auto match = index.find(below, above, kBetweenPoses_s);
  ASSERT_TRUE(match);
  // All bodies are 0.03 m off and 0.4 m/s too fast: D = sqrt(0.03^2 + (0.1 x 0.4)^2).
  EXPECT_NEAR(match->distance_m, 0.05F, 1e-4F);
  EXPECT_FALSE(index.find(below, above, kBetweenPoses_s, 0.049F));
  EXPECT_TRUE(index.find(below, above, kBetweenPoses_s, 0.051F));
}

TEST(ReactionClips, FindNothingBeyondTheMaximumDistance) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  motion::Pose lying = scenes::standing(character().skeleton);
  scenes::turn(lying, motion::Role::pelvis, Eigen::Vector3f::UnitY(), 90);
  lying.root_position.z() = 0.15F;
  EXPECT_FALSE(index.find(lying, lying, kBetweenPoses_s));
  EXPECT_FALSE(ReactionClips(character(), {}).find(lying, lying, kBetweenPoses_s));
  const ReactionClips none(character(), all, motion::Purpose::idle);
  EXPECT_EQ(none.size(), 0U);
}

TEST(ReactionClips, RejectNonFiniteInput) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  const motion::Pose good = scenes::standing(character().skeleton);
  motion::Pose bad = good;
  bad.rotation[motion::Role::head].x() = tests::kNan;
  EXPECT_TRUE(index.find(good, good, kBetweenPoses_s));
  EXPECT_FALSE(index.find(bad, good, kBetweenPoses_s));
  EXPECT_FALSE(index.find(good, bad, kBetweenPoses_s));
  for (float dt_s : {0.0F, -1.0F, tests::kNan}) EXPECT_FALSE(index.find(good, good, dt_s));
}

TEST(ReactionClips, MatchLeavesTimeToPlay) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  for (const motion::Clip& clip : all) {
    const auto match =
        index.find(clip.motion.poses.back(), clip.motion.poses.back(), kBetweenPoses_s);
    ASSERT_TRUE(match);
    const motion::Clip& found = all[static_cast<std::size_t>(match->clip)];
    EXPECT_LE(match->time_s, found.motion.duration_s() - 0.3F + 1e-5F);
  }
}

}  // namespace
}  // namespace flinch::reaction
