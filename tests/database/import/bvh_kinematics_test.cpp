// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "database/import/bvh.h"
#include "tests/database/import/bvh_samples.h"

namespace flinch::database {
namespace {

using tests::replaced;

// The textbook rotation matrices about X, Y and Z.
Eigen::Matrix3d rotation_about(char axis, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  Eigen::Matrix3d matrix;
  if (axis == 'X') {
    matrix << 1, 0, 0, 0, c, -s, 0, s, c;
  } else if (axis == 'Y') {
    matrix << c, 0, s, 0, 1, 0, -s, 0, c;
  } else {
    matrix << c, -s, 0, s, c, 0, 0, 0, 1;
  }
  return matrix;
}

void expect_near(const Eigen::Vector3d& got, const Eigen::Vector3d& expected) {
  EXPECT_LT((got - expected).norm(), 1e-12) << got.transpose() << " for " << expected.transpose();
}

std::string channels_in(const std::string& order) {
  std::string text;
  for (const char axis : order) text += std::string(" ") + axis + "rotation";
  return text;
}

/// A root with position channels and rotations in `order`, a child with `child_order`, one frame.
Bvh two_joints(const std::string& order, const std::string& child_order,
               const std::vector<double>& values) {
  std::ostringstream text;
  text.precision(17);
  text << "HIERARCHY\nROOT a\n{\nOFFSET 7 8 9\nCHANNELS 6 Xposition Yposition Zposition"
       << channels_in(order) << "\nJOINT b\n{\nOFFSET 1 2 3\nCHANNELS 3" << channels_in(child_order)
       << "\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n";
  for (const double value : values) text << value << ' ';
  return parse_bvh(text.str(), "two_joints");
}

TEST(BvhKinematics, EveryOrderOfRotationsIsTheProductOfMatricesInThatOrder) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> degrees(-360, 360);
  std::string order = "XYZ";
  int orders = 0;
  do {
    ++orders;
    const std::string child_order{order[2], order[0], order[1]};
    const double p = degrees(random), q = degrees(random), r = degrees(random);
    const double u = degrees(random), v = degrees(random), w = degrees(random);
    const BvhFrame frame =
        forward_kinematics(two_joints(order, child_order, {1.5, -2, 4, p, q, r, u, v, w}), 0);
    const Eigen::Matrix3d root =
        rotation_about(order[0], p) * rotation_about(order[1], q) * rotation_about(order[2], r);
    const Eigen::Matrix3d child = root * rotation_about(child_order[0], u) *
                                  rotation_about(child_order[1], v) *
                                  rotation_about(child_order[2], w);
    expect_near(frame.position[0], {1.5, -2, 4});
    expect_near(frame.position[1], Eigen::Vector3d(1.5, -2, 4) + root * Eigen::Vector3d(1, 2, 3));
    EXPECT_LT((frame.orientation[0].toRotationMatrix() - root).norm(), 1e-12) << order;
    EXPECT_LT((frame.orientation[1].toRotationMatrix() - child).norm(), 1e-12) << order;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 6);
}

// Derived by hand: a quarter turn about Z takes X to Y, then one about the rotated X.
TEST(BvhKinematics, QuarterTurnMovesTheChild) {
  const BvhFrame frame =
      forward_kinematics(two_joints("ZXY", "XYZ", {0, 0, 0, 90, 0, 0, 90, 0, 0}), 0);
  expect_near(frame.position[1], {-2, 1, 3});
  expect_near(frame.orientation[1] * Eigen::Vector3d::UnitX(), {0, 1, 0});
  expect_near(frame.orientation[1] * Eigen::Vector3d::UnitY(), {0, 0, 1});
}

TEST(BvhKinematics, RotationsMayComeBeforePositions) {
  const std::string before =
      "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation";
  const Bvh plain = parse_bvh(tests::kPlainBvh, "plain");
  const std::string first =
      replaced(replaced(tests::kPlainBvh, before,
                        "CHANNELS 6 Zrotation Xrotation Yrotation Xposition Yposition Zposition"),
               "\n1 2 3 4 5 6 ", "\n4 5 6 1 2 3 ");
  const BvhFrame one = forward_kinematics(plain, 0);
  const BvhFrame other = forward_kinematics(parse_bvh(first, "first"), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.position[i], other.position[i]);
    EXPECT_EQ(one.orientation[i].coeffs(), other.orientation[i].coeffs());
  }
}

TEST(BvhKinematics, PositionsReplaceTheirComponentOfTheOffset) {
  const std::string text =
      "HIERARCHY\nROOT a\n{\nOFFSET 10 20 30\nCHANNELS 1 Yposition\nJOINT b\n{\nOFFSET 1 2 3\n"
      "CHANNELS 2 Zposition Xposition\n}\n}\nMOTION\nFrames: 2\nFrame Time: 1\n5 6 7\n8 9 4\n";
  const Bvh bvh = parse_bvh(text, "positions");
  const BvhFrame first = forward_kinematics(bvh, 0);
  expect_near(first.position[0], {10, 5, 30});
  expect_near(first.position[1], {17, 7, 36});
  expect_near(forward_kinematics(bvh, 1).position[1], {14, 10, 39});
}

TEST(BvhKinematics, TheRestFrameIsTheOffsetsAlone) {
  const BvhFrame rest = rest_frame(two_joints("ZXY", "XYZ", {1, 1, 1, 90, 20, 30, 40, 50, 60}));
  expect_near(rest.position[0], {7, 8, 9});
  expect_near(rest.position[1], {8, 10, 12});
  EXPECT_EQ(rest.orientation[1].coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

}  // namespace
}  // namespace flinch::database
