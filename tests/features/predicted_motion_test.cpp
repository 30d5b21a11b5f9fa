// SPDX-License-Identifier: MIT
#include "features/predicted_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/collision_shape.h"
#include "tests/features/moving_figure.h"
#include "tests/motion/random_motion.h"

namespace flinch::features {
namespace {

const tests::SwayingFigure& figure() {
  static const tests::SwayingFigure figure;
  return figure;
}

TEST(MotionBounds, ContainThePelvisAndBoundSurfaceSpeeds) {
  std::mt19937 random(1);
  const CharacterState state{.idle_time_s = 0.3F, .position = {2, -1}, .facing = 0.7F};
  const MotionBounds bounds = placed(figure().motion_bounds, figure().idle, state, 2);
  double fastest = 0;
  for (int i = 0; i < 4000; ++i) {
    const float time_s = tests::uniform(random, 0, 12);
    const float step_s = tests::uniform(random, 0.001F, 0.2F);
    const motion::Pose now = idle_pose(figure().idle, state, time_s);
    const motion::Pose then = idle_pose(figure().idle, state, time_s + step_s);
    EXPECT_LE((now.root_position - bounds.pelvis_centre).norm(), bounds.radius + 1e-5F);
    const Eigen::Vector3d point =
        (now.root_position + tests::random_vector(random, 1.2F)).cast<double>();
    const auto body = static_cast<motion::Body>(random() % motion::kBodyCount);
    const double change =
        std::abs(figure().gap_of(body, then, point, 0) - figure().gap_of(body, now, point, 0));
    EXPECT_LE(change, static_cast<double>(bounds.max_speed_mps * step_s) + 1e-6);
    fastest = std::max(fastest, change / static_cast<double>(step_s));
  }
  // The bound is not far above the fastest point.
  EXPECT_GT(fastest, 0.4 * static_cast<double>(bounds.max_speed_mps));
}

// The fingertips move twice as fast as the middle of the hand.
TEST(MotionBounds, IncludeRotationOfABody) {
  motion::Motion motion;
  for (int i = 0; i <= 10; ++i) {
    motion::Pose pose = figure().standing;
    pose.rotation[motion::Role::left_hand] =
        Eigen::AngleAxisf(0.05F * static_cast<float>(i), Eigen::Vector3f::UnitX());
    motion.poses.push_back(pose);
  }
  const MotionBounds bounds = motion_bounds_of(figure().character.skeleton, figure().model, motion);
  const float fingers_m = figure().character.skeleton.tip[motion::Role::left_hand].norm();
  EXPECT_GE(bounds.max_speed_mps, 0.05F * 60 * fingers_m);
  EXPECT_LE(bounds.max_speed_mps, 2 * 0.05F * 60 * fingers_m);
}

TEST(CollisionFigure, NoPoseExceedsItsReach) {
  std::mt19937 random(2);
  const double reach = static_cast<double>(figure().collision_figure.reach_m);
  double farthest = 0;
  for (int i = 0; i < 2000; ++i) {
    const motion::Pose pose = tests::random_pose(random);
    const Eigen::Vector3d direction = tests::random_direction(random).cast<double>();
    // A surface point beyond the reach would be nearer than this to a point 10 m away.
    const Eigen::Vector3d root = pose.root_position.cast<double>();
    const double extent = 10 - figure().gap(pose, root + 10 * direction, 0);
    EXPECT_LE(extent, reach + 1e-5);
    farthest = std::max(farthest, extent);
  }
  EXPECT_GT(farthest, 0.5 * reach);
}

TEST(CollisionFigure, NoBodyExceedsItsReach) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const motion::JointFrames frames =
        forward_kinematics(figure().character.skeleton, tests::random_pose(random));
    const Eigen::Vector3d point = tests::random_vector(random, 3).cast<double>();
    for (motion::Body body : motion::kBodies) {
      const motion::CollisionShape outline =
          motion::collision_shape_of(figure().model, frames, body);
      const Eigen::Vector3d joint = frames.position[role_of(body)].cast<double>();
      const double reach = static_cast<double>(figure().collision_figure.body_reach_m[body]);
      EXPECT_GE(gap(point, 0, outline), (point - joint).norm() - reach - 1e-5);
    }
  }
}

}  // namespace
}  // namespace flinch::features
