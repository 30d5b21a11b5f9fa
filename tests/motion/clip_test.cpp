// SPDX-License-Identifier: MIT
#include "motion/clip.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "motion/default_character.h"
#include "motion/interpolation.h"
#include "motion/mirror.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using tests::random_pose;

Motion smooth_motion(std::mt19937& random, int poses) {
  const Pose from = random_pose(random, 1);
  const Pose to = random_pose(random, 1);
  Motion motion;
  for (int i = 0; i < poses; ++i) {
    motion.poses.push_back(blend(from, to, static_cast<float>(i) / static_cast<float>(poses - 1)));
  }
  return motion;
}

TEST(Sample, ReturnsStoredPosesAndClampsAtTheEnds) {
  std::mt19937 random(1);
  const Motion motion = smooth_motion(random, 31);
  for (int i = 0; i < 31; ++i) {
    const Pose& expected = motion.poses[static_cast<std::size_t>(i)];
    EXPECT_LT(tests::distance(sample(motion, static_cast<float>(i) / 60), expected), 1e-3F);
  }
  EXPECT_EQ(tests::distance(sample(motion, -1), motion.poses.front()), 0);
  EXPECT_EQ(tests::distance(sample(motion, 99), motion.poses.back()), 0);
}

TEST(Sample, SubsetOfRolesMatchesTheWholePoseBitForBit) {
  constexpr std::array kSome{Role::pelvis, Role::right_thigh, Role::right_shin};
  std::mt19937 random(3);
  const Motion motion = smooth_motion(random, 31);
  for (const float time_s : {-1.0F, 0.1F, 0.123F, 0.77F, 99.0F}) {
    const Pose all = sample_ping_pong(motion, time_s);
    const Pose some = sample_ping_pong(motion, time_s, kSome);
    EXPECT_EQ(some.root_position, all.root_position);
    for (const Role role : kSome) EXPECT_EQ(some.rotation[role], all.rotation[role]);
  }
}

TEST(SamplePingPong, IsContinuousAtBothEnds) {
  std::mt19937 random(2);
  const Motion motion = smooth_motion(random, 31);
  const float step_s = 0.001F;
  const float max_step = tests::distance(motion.poses.front(), motion.poses.back()) * 0.01F;
  Pose last = sample_ping_pong(motion, 0);
  for (int i = 1; i < 3000; ++i) {
    const Pose pose = sample_ping_pong(motion, static_cast<float>(i) * step_s);
    EXPECT_LT(tests::distance(pose, last), max_step) << i;
    last = pose;
  }
  const float duration = motion.duration_s();
  EXPECT_LT(tests::distance(sample_ping_pong(motion, duration), motion.poses.back()), 1e-4F);
  EXPECT_LT(tests::distance(sample_ping_pong(motion, 2 * duration), motion.poses.front()), 1e-4F);
  EXPECT_LT(
      tests::distance(sample_ping_pong(motion, 1.5F * duration), sample(motion, 0.5F * duration)),
      1e-4F);
}

TEST(PoseBefore, HasTheSignsOfASample) {
  std::mt19937 random(8);
  Motion motion = smooth_motion(random, 31);
  for (Pose& pose : motion.poses) {
    for (Eigen::Quaternionf& rotation : pose.rotation) {
      if (random() % 2 == 0) rotation.coeffs() *= -1;
    }
  }
  for (int i = 0; i < 500; ++i) {
    const float time_s = tests::uniform(random, -0.2F, 2);
    const Pose pose = sample(motion, time_s);
    const Pose there = sample_ping_pong(motion, time_s);
    for (Role role : kRoles) {
      EXPECT_GT(pose.rotation[role].dot(pose_before(motion, time_s).rotation[role]), 0);
      EXPECT_GT(there.rotation[role].dot(pose_before_ping_pong(motion, time_s).rotation[role]), 0);
    }
  }
}

TEST(SamplePingPong, ReturnsTheOnlyPose) {
  std::mt19937 random(3);
  Motion motion;
  motion.poses = {random_pose(random)};
  EXPECT_EQ(tests::distance(sample_ping_pong(motion, 1.3F), motion.poses.front()), 0);
}

TEST(Mirror, IsItsOwnInverseBitForBit) {
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random_pose(random);
    const Pose twice = mirrored(mirrored(pose));
    EXPECT_EQ(twice.root_position, pose.root_position);
    for (Role role : kRoles) EXPECT_EQ(twice.rotation[role].coeffs(), pose.rotation[role].coeffs());
  }
}

TEST(Mirror, MovesEveryJointToItsMirrorImage) {
  std::mt19937 random(5);
  const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random_pose(random);
    const JointFrames frames = forward_kinematics(skeleton, pose);
    const JointFrames images = forward_kinematics(skeleton, mirrored(pose));
    for (Role role : kRoles) {
      Eigen::Vector3f image = frames.position[role];
      image.y() = -image.y();
      EXPECT_LT((images.position[mirrored(role)] - image).norm(), 1e-5F);
    }
  }
}

TEST(Mirror, NegatesTheClipsDirectionAndRecordsItsSource) {
  constexpr float kPi = std::numbers::pi_v<float>;
  std::mt19937 random(6);
  Clip clip;
  clip.name = "duck";
  clip.annotation =
      Annotation{.direction = kPi / 4, .onset_s = 0.1F, .peak_s = 0.2F, .end_s = 0.4F};
  clip.motion = smooth_motion(random, 31);
  const Clip image = mirrored(clip);
  EXPECT_EQ(image.name, "duck_mirrored");
  EXPECT_EQ(image.mirrored_from, "duck");
  EXPECT_EQ(image.annotation->direction, -kPi / 4);
  EXPECT_EQ(image.annotation->peak_s, 0.2F);
  clip.annotation->direction = kPi;  // a mirrored threat from behind still comes from behind
  EXPECT_EQ(mirrored(clip).annotation->direction, kPi);
}

}  // namespace
}  // namespace flinch::motion
