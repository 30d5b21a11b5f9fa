// SPDX-License-Identifier: MIT
#include "reaction/reaction_clips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "motion/interpolation.h"
#include "motion/mirror.h"
#include "motion/rotation.h"
#include "tests/scenes/not_finite.h"
#include "tests/sim/figure_motions.h"

namespace flinch::reaction {
namespace {

constexpr float kBetweenPoses_s = 1.0F / 60;
const Eigen::Vector2f kNoBlow = Eigen::Vector2f::Zero();

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
    const Eigen::Vector2f push_mps = Eigen::Rotation2Df(yaw) * push_of(character(), all[i].motion);
    const auto match =
        index.find(posed(time_s - kBetweenPoses_s), posed(time_s), kBetweenPoses_s, push_mps);
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
  const auto match = index.find(below, above, kBetweenPoses_s, kNoBlow);
  ASSERT_TRUE(match);
  // All bodies are 0.03 m off and 0.4 m/s too fast: D = sqrt(0.03^2 + (0.1 x 0.4)^2).
  EXPECT_NEAR(match->distance_m, 0.05F, 1e-4F);
  EXPECT_FALSE(index.find(below, above, kBetweenPoses_s, kNoBlow, 0.049F));
  EXPECT_TRUE(index.find(below, above, kBetweenPoses_s, kNoBlow, 0.051F));
}

TEST(ReactionClips, FindNothingBeyondTheMaximumDistance) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  motion::Pose lying = scenes::standing(character().skeleton);
  scenes::turn(lying, motion::Role::pelvis, Eigen::Vector3f::UnitY(), 90);
  lying.root_position.z() = 0.15F;
  EXPECT_FALSE(index.find(lying, lying, kBetweenPoses_s, kNoBlow));
  EXPECT_FALSE(ReactionClips(character(), {}).find(lying, lying, kBetweenPoses_s, kNoBlow));
  const ReactionClips none(character(), all, motion::Purpose::idle);
  EXPECT_EQ(none.size(), 0U);
}

TEST(ReactionClips, RejectNonFiniteInput) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  const motion::Pose good = scenes::standing(character().skeleton);
  motion::Pose bad = good;
  bad.rotation[motion::Role::head].x() = tests::kNan;
  EXPECT_TRUE(index.find(good, good, kBetweenPoses_s, kNoBlow));
  EXPECT_FALSE(index.find(bad, good, kBetweenPoses_s, kNoBlow));
  EXPECT_FALSE(index.find(good, bad, kBetweenPoses_s, kNoBlow));
  EXPECT_FALSE(index.find(good, good, kBetweenPoses_s, {tests::kNan, 0}));
  for (float dt_s : {0.0F, -1.0F, tests::kNan}) EXPECT_FALSE(index.find(good, good, dt_s, kNoBlow));
}

TEST(ReactionClips, MatchLeavesTimeToPlay) {
  const auto all = clips();
  const ReactionClips index(character(), all);
  for (const motion::Clip& clip : all) {
    const auto match =
        index.find(clip.motion.poses.back(), clip.motion.poses.back(), kBetweenPoses_s, kNoBlow);
    ASSERT_TRUE(match);
    const motion::Clip& found = all[static_cast<std::size_t>(match->clip)];
    EXPECT_LE(match->time_s, found.motion.duration_s() - 0.3F + 1e-5F);
  }
}

constexpr float kPushed_s = 0.5F;

/// A standing body that is carried by `way_m` along a minimum-jerk curve over 0.5 s, and then half
/// the way back over a second; the left arm comes up a little meanwhile.
motion::Clip pushed(const Eigen::Vector2f& way_m) {
  motion::Clip clip;
  clip.name = "pushed";
  clip.purpose = motion::Purpose::push;
  for (int k = 0; k <= 120; ++k) {
    const float time_s = static_cast<float>(k) / clip.motion.rate_hz;
    const float there = motion::minimum_jerk(time_s / kPushed_s);
    const float back = motion::minimum_jerk(time_s - kPushed_s) / 2;
    motion::Pose pose = scenes::standing(character().skeleton);
    scenes::turn(pose, motion::Role::left_forearm, Eigen::Vector3f::UnitZ(), -40 * there);
    pose.root_position.head<2>() += (there - back) * way_m;
    clip.motion.poses.push_back(pose);
  }
  return clip;
}

TEST(ReactionClips, PushIsTheFastestTenthOfASecondTowardTheFarthestPoint) {
  const Eigen::Vector2f way_m(-0.3F, 0.1F);
  motion::Clip clip = pushed(way_m);
  for (motion::Pose& pose : clip.motion.poses)
    pose.rotation[motion::Role::left_forearm] =
        clip.motion.poses.front().rotation[motion::Role::left_forearm];
  // The curve is steepest in its middle.
  const float share = motion::minimum_jerk(0.5F + 0.05F / kPushed_s) -
                      motion::minimum_jerk(0.5F - 0.05F / kPushed_s);
  EXPECT_LT((push_of(character(), clip.motion) - share / 0.1F * way_m).norm(), 1e-4F);
  clip.motion.poses.resize(1);
  EXPECT_TRUE(push_of(character(), clip.motion).isZero(0));
}

/// A character that stands still, turned by `yaw`, right after the blow.
std::optional<ReactionMatch> find_after(const std::vector<motion::Clip>& clips, float yaw,
                                        const Eigen::Vector2f& blow_mps) {
  const motion::Pose pose = motion::placed(scenes::standing(character().skeleton), yaw, {1, 2, 0});
  return ReactionClips(character(), clips)
      .find(pose, pose, kBetweenPoses_s, Eigen::Rotation2Df(yaw) * blow_mps);
}

TEST(ReactionClips, ABlowFromTheFrontGetsNoClipPushedFromBehind) {
  const motion::Clip forward = pushed({0.2F, 0});
  const motion::Clip backward = pushed({-0.2F, 0});
  for (const float yaw : {0.0F, 2.0F, -1.0F}) {
    EXPECT_FALSE(find_after({forward}, yaw, {-0.2F, 0}));
    EXPECT_TRUE(find_after({forward}, yaw, {0.2F, 0}));
    const auto match = find_after({forward, backward}, yaw, {-0.2F, 0.1F});
    ASSERT_TRUE(match);
    EXPECT_EQ(match->clip, 1);
  }
}

TEST(ReactionClips, AMirroredBlowGetsTheMirroredClip) {
  const motion::Clip left = pushed({-0.1F, 0.2F});
  const motion::Clip right = motion::mirrored(left);
  for (const float yaw : {0.0F, 2.0F, -1.0F}) {
    const auto to_left = find_after({left, right}, yaw, {-0.1F, 0.3F});
    const auto to_right = find_after({left, right}, yaw, {-0.1F, -0.3F});
    ASSERT_TRUE(to_left && to_right);
    EXPECT_EQ(to_left->clip, 0);
    EXPECT_EQ(to_right->clip, 1);
    EXPECT_NEAR(to_left->distance_m, to_right->distance_m, 1e-5F);
  }
}

TEST(ReactionClips, AngleAndStrengthOfABlowAreBounded) {
  const std::vector clips{pushed({-0.2F, 0})};
  const float push_mps = -push_of(character(), clips[0].motion).x();
  const auto fits = [&](float degrees, float blow_mps) {
    const Eigen::Vector2f blow =
        Eigen::Rotation2Df(motion::radians(degrees)) * Eigen::Vector2f(-blow_mps, 0);
    return find_after(clips, 0, blow).has_value();
  };
  for (const float sign : {-1.0F, 1.0F}) {
    EXPECT_TRUE(fits(sign * 58, 0.3F));
    EXPECT_FALSE(fits(sign * 62, 0.3F));
  }
  EXPECT_TRUE(fits(0, push_mps + 0.74F));
  EXPECT_FALSE(fits(0, push_mps + 0.76F));
}

}  // namespace
}  // namespace flinch::reaction
