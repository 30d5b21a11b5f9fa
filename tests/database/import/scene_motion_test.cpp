// SPDX-License-Identifier: MIT
#include "database/import/scene_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using Eigen::Affine3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::HasSubstr;

SceneNode node(const std::string& name, int parent, const Vector3d& offset) {
  SceneNode made;
  made.name = name;
  made.parent = parent;
  made.local.translation() = offset;
  return made;
}

void turn_about_x(SceneNode& moved, const std::vector<double>& times_s, double rate) {
  moved.is_animated = true;
  moved.track.rotation_times_s = times_s;
  for (const double time_s : times_s) {
    moved.track.rotations.emplace_back(Eigen::AngleAxisd(rate * time_s, Vector3d::UnitX()));
  }
}

std::vector<double> times(int count, double interval_s) {
  std::vector<double> made;
  for (int k = 0; k < count; ++k) made.push_back(k * interval_s);
  return made;
}

// world > armature > hips > knee > end, and beside them a ball with a mesh. Hips and knee turn.
Scene leg(const std::vector<double>& times_s) {
  Scene scene;
  scene.path = "leg.glb";
  scene.nodes = {node("", -1, {0, 0, 0}),      node("armature", 0, {0, 1, 0}),
                 node("hips", 1, {0, 0, 0}),   node("knee", 2, {0, -0.5, 0}),
                 node("end", 3, {0, -0.4, 0}), node("ball", 0, {5, 5, 5})};
  turn_about_x(scene.nodes[2], times_s, 1);
  turn_about_x(scene.nodes[3], times_s, 2);
  turn_about_x(scene.nodes[5], times_s, 3);
  scene.nodes[5].has_mesh = true;
  return scene;
}

// The knee goes round the hips, the end round the knee: by hand.
TEST(SceneMotion, TheLargestTreeOfMovingNodesIsTheFigure) {
  const Bvh bvh = scene_motion(leg(times(31, 0.02)));
  ASSERT_EQ(bvh.joints.size(), 2U);
  EXPECT_EQ(bvh.joints[0].name, "hips");
  EXPECT_EQ(bvh.joints[1].name, "knee");
  ASSERT_EQ(bvh.joints[1].end_sites.size(), 1U);
  EXPECT_LT((bvh.joints[1].end_sites[0] - Vector3d(0, -0.4, 0)).norm(), 1e-12);
  EXPECT_EQ(bvh.frame_count, 31);
  EXPECT_NEAR(bvh.frame_time_s, 0.02, 1e-12);
  EXPECT_EQ(bvh.channel_count, 9);
  for (int frame = 0; frame < 31; ++frame) {
    const double angle = 0.02 * frame;
    const BvhFrame places = forward_kinematics(bvh, frame);
    const Vector3d knee(0, 1 - 0.5 * std::cos(angle), -0.5 * std::sin(angle));
    EXPECT_LT((places.position[1] - knee).norm(), 1e-12);
    const Vector3d end = knee + 0.4 * Vector3d(0, -std::cos(3 * angle), -std::sin(3 * angle));
    EXPECT_LT(
        (places.position[1] + places.orientation[1] * bvh.joints[1].end_sites[0] - end).norm(),
        1e-12);
  }
}

// Every node's axes turned and scaled by a constant: the nodes below compensate for it.
TEST(SceneMotion, AxesAndScalesOfNodesDoNotMatter) {
  const Scene plain = leg(times(31, 0.02));
  const Bvh expected = scene_motion(plain);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Scene other = plain;
    std::vector<Affine3d> axes(other.nodes.size(), Affine3d::Identity());
    for (std::size_t i = 1; i < other.nodes.size(); ++i) {
      SceneNode& changed = other.nodes[i];
      const Quaterniond turn =
          Quaterniond(number(random), number(random), number(random), number(random)).normalized();
      const double scale = std::exp(2 * number(random));
      axes[i] = turn * Eigen::Scaling(scale);
      const auto parent = static_cast<std::size_t>(changed.parent);
      const Affine3d before = axes[parent].inverse();
      const Affine3d bare = changed.local;
      changed.local = before * bare * axes[i];
      if (!changed.is_animated) continue;
      SceneTrack& track = changed.track;
      const Quaterniond parent_turn(Eigen::Matrix3d(axes[parent].rotation()));
      for (Quaterniond& rotation : track.rotations)
        rotation = parent_turn.conjugate() * rotation * turn;
      track.position_times_s = track.scale_times_s = {0};
      track.positions = {changed.local.translation()};
      track.scales = {changed.local.linear().colwise().norm()};
    }
    const Bvh found = scene_motion(other);
    ASSERT_EQ(found.joints.size(), expected.joints.size());
    for (int frame = 0; frame < expected.frame_count; ++frame) {
      const BvhFrame places = forward_kinematics(found, frame);
      const BvhFrame wanted = forward_kinematics(expected, frame);
      for (std::size_t i = 0; i < wanted.position.size(); ++i) {
        ASSERT_LT((places.position[i] - wanted.position[i]).norm(), 1e-9);
        ASSERT_LT(places.orientation[i].angularDistance(wanted.orientation[i]), 1e-7);
      }
    }
  }
}

TEST(SceneMotion, KeysSetByHandBecomeFramesAtThirtyHertz) {
  const Bvh bvh = scene_motion(leg({0, 1, 2}));
  EXPECT_EQ(bvh.frame_count, 61);
  EXPECT_NEAR(bvh.frame_time_s, 1.0 / 30, 1e-12);
  const Vector3d knee(0, 1 - 0.5 * std::cos(0.5), -0.5 * std::sin(0.5));
  EXPECT_LT((forward_kinematics(bvh, 15).position[1] - knee).norm(), 1e-9);
  EXPECT_THAT(bvh.warnings, testing::ElementsAre(HasSubstr("keys are up to 1.00 s apart")));
}

TEST(SceneMotion, FewKeysCannotMakeManyFrames) {
  EXPECT_THAT(tests::error_of([] {
                scene_motion(leg({0, 1e6}));
              }),
              HasSubstr("leg.glb: its few keys make 30000001 frames"));
  std::vector<double> dense = times(100, 0.001);
  dense.push_back(1e300);
  EXPECT_THAT(tests::error_of([&] { scene_motion(leg(dense)); }), HasSubstr("which is too many"));
}

TEST(SceneMotion, ASceneWithoutAFigureIsRefused) {
  Scene scene = leg(times(3, 0.1));
  for (SceneNode& still : scene.nodes) still.is_animated = false;
  EXPECT_THAT(tests::error_of([&] { scene_motion(scene); }), HasSubstr("no animated figure"));
}

}  // namespace
}  // namespace flinch::database
