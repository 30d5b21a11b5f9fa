// SPDX-License-Identifier: MIT
#include "database/quality/quality.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/database/author/author_scene.h"

namespace flinch::database {
namespace {

using motion::Clip;
using motion::degrees;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::Side;
using test::AuthorScene;
using testing::Contains;
using testing::IsEmpty;

Clip still_clip(const motion::Pose& pose, int count = 30) {
  Clip clip;
  clip.name = "still";
  clip.motion.poses.assign(static_cast<std::size_t>(count), pose);
  return clip;
}

TEST(Quality, StandingStillMeetsAllBounds) {
  const AuthorScene scene;
  const ClipQuality quality = measure_quality(scene.figure, still_clip(scene.start));
  EXPECT_THAT(broken_bounds(quality), IsEmpty());
  EXPECT_EQ(quality.limit_excess_deg, 0);
  EXPECT_EQ(quality.peak_acceleration_mps2, 0);
  EXPECT_GT(quality.balance_margin_m, 0.05F);
}

TEST(Quality, DetectsAHyperextendedKnee) {
  const AuthorScene scene;
  motion::Pose pose = scene.start;
  pose.rotation[Role::left_shin] = rotation_about(Eigen::Vector3f::UnitY(), radians(-25));
  const ClipQuality quality = measure_quality(scene.figure, still_clip(pose));
  EXPECT_NEAR(quality.limit_excess_deg, 20, 0.01);
  EXPECT_EQ(quality.limit_joint, "left_knee");
  EXPECT_THAT(broken_bounds(quality), Contains("limit_excess_deg"));
}

TEST(Quality, TheUsualExcessIsThatOfHalfOfTheClip) {
  const AuthorScene scene;
  motion::Pose bent = scene.start;
  bent.rotation[Role::left_shin] = rotation_about(Eigen::Vector3f::UnitY(), radians(-25));
  for (std::size_t bent_count : {14U, 16U}) {
    Clip clip = still_clip(scene.start, 30);
    std::fill_n(clip.motion.poses.begin(), bent_count, bent);
    const ClipQuality quality = measure_quality(scene.figure, clip);
    EXPECT_NEAR(quality.limit_excess_deg, 20, 0.01);
    EXPECT_NEAR(quality.usual_limit_excess_deg, bent_count > 15 ? 20 : 0, 0.01) << bent_count;
  }
}

TEST(Quality, FewPosesGiveTheMeasuresOfJointsAndFeet) {
  const AuthorScene scene;
  Clip clip = still_clip(scene.start);
  for (std::size_t k = 0; k < clip.motion.poses.size(); ++k) {
    motion::Pose& pose = clip.motion.poses[k];
    pose.root_position.x() += 0.001F * static_cast<float>(k);
    pose.rotation[Role::left_shin] = rotation_about(Eigen::Vector3f::UnitY(), radians(-25));
  }
  const ClipQuality whole = measure_quality(scene.figure, clip);
  const ClipQuality few = measure_joints_and_feet(scene.figure, clip, clip.motion.rate_hz / 3);
  EXPECT_NEAR(few.usual_limit_excess_deg, whole.usual_limit_excess_deg, 0.01F);
  EXPECT_EQ(few.usual_limit_joint, whole.usual_limit_joint);
  EXPECT_NEAR(few.support_drift_m, whole.support_drift_m, 0.0025F);
}

TEST(Quality, DetectsAHandInsideTheTrunk) {
  const AuthorScene scene;
  motion::Pose pose = scene.start;
  const Eigen::Vector3f inside = scene.frames.position[Role::abdomen] + Eigen::Vector3f(0, 0, 0.1F);
  solve_arm(scene.figure.skeleton(), scene.frames, Side::left,
            {inside, -Eigen::Vector3f::UnitX(), 0}, pose);
  EXPECT_LT(measure_quality(scene.figure, still_clip(pose)).hand_clearance_m, 0);
}

TEST(Quality, DetectsSlidingAndPenetratingFeet) {
  const AuthorScene scene;
  Clip slipping = still_clip(scene.start);
  for (std::size_t k = 0; k < slipping.motion.poses.size(); ++k) {
    slipping.motion.poses[k].root_position.x() += 0.001F * static_cast<float>(k);
  }
  EXPECT_NEAR(measure_quality(scene.figure, slipping).support_drift_m, 0.029F, 1e-4F);
  motion::Pose sunk = scene.start;
  sunk.root_position.z() -= 0.01F;
  EXPECT_NEAR(measure_quality(scene.figure, still_clip(sunk)).foot_below_ground_m, 0.01F, 2e-4F);
}

TEST(Quality, DetectsALossOfBalance) {
  const AuthorScene scene;
  const motion::Pose leaning = motion::placed(scene.start, 0, Eigen::Vector3f::Zero());
  motion::Pose pose = leaning;
  pose.root_position.x() += 0.25F;
  pose.root_position.z() -= 0.08F;
  pose = with_feet(scene.figure.skeleton(), pose,
                   {foot_pose(scene.frames, Side::left), foot_pose(scene.frames, Side::right)});
  EXPECT_LT(measure_quality(scene.figure, still_clip(pose)).balance_margin_m, 0);
}

// A head that turns 10 degrees per pose at 60 Hz reaches 600 of the neck's 700 degrees per second.
TEST(Quality, MeasuresSpeedRelativeToHumanPeakSpeed) {
  const AuthorScene scene;
  Clip clip = still_clip(scene.start, 8);
  for (std::size_t k = 0; k < clip.motion.poses.size(); ++k) {
    clip.motion.poses[k].rotation[Role::head] =
        scene.start.rotation[Role::head] *
        rotation_about(Eigen::Vector3f::UnitZ(), radians(10) * static_cast<float>(k));
  }
  const ClipQuality quality = measure_quality(scene.figure, clip);
  EXPECT_NEAR(quality.speed_share, 600.0F / 700, 0.01F);
  EXPECT_EQ(quality.speed_joint, "neck");
}

// The whole figure accelerates at a constant 3 m/s^2.
TEST(Quality, MeasuresAcceleration) {
  const AuthorScene scene;
  Clip clip = still_clip(scene.start, 20);
  for (std::size_t k = 0; k < clip.motion.poses.size(); ++k) {
    const float time = static_cast<float>(k) / 60;
    clip.motion.poses[k].root_position.x() += 1.5F * time * time;
  }
  EXPECT_NEAR(measure_quality(scene.figure, clip).peak_acceleration_mps2, 3, 0.05);
}

}  // namespace
}  // namespace flinch::database
