// SPDX-License-Identifier: MIT
#include "motion/skin/control_cage.h"

#include <gtest/gtest.h>

#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// A cube with corners at +-1; the upper half moves with the head, the lower one with the neck.
ControlCage cube() {
  CageBuilder builder;
  const JointWeights lower = joint_weights({{Role::neck, 1}});
  const JointWeights upper = joint_weights({{Role::head, 1}});
  const Ring bottom =
      builder.add(std::vector<Vector3f>{{1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, -1}}, lower);
  const Ring top =
      builder.add(std::vector<Vector3f>{{1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}, upper);
  builder.join(bottom, top, Covering::shirt, false);
  builder.face(top, Covering::hair, false);
  builder.face(bottom, Covering::shoes, true);
  return std::move(builder).cage();
}

// By hand, from the rule: faces' centres stay at distance 1; an edge's middle (1, 1, 0) becomes
// ((1, 1, 1) + (1, 1, -1) + (1, 0, 0) + (0, 1, 0)) / 4; a corner of three edges becomes a third of
// the mean of its faces, (1, 1, 1) / 3, and twice the mean of its edges' middles, 2/3 (1, 1, 1).
TEST(ControlCage, SubdividedCubeHasThePointsOfCatmullAndClark) {
  const ControlCage fine = subdivided(cube());
  ASSERT_EQ(fine.vertices.size(), 8U + 12U + 6U);
  EXPECT_EQ(fine.faces.size(), 24U);
  int corners = 0;
  int middles = 0;
  int centres = 0;
  for (const ControlCage::Vertex& vertex : fine.vertices) {
    Vector3f size = vertex.position.cwiseAbs();
    std::sort(size.begin(), size.end());
    corners += (size - Vector3f::Constant(5.0F / 9)).norm() < 1e-6F;
    middles += (size - Vector3f(0, 0.75F, 0.75F)).norm() < 1e-6F;
    centres += (size - Vector3f(0, 0, 1)).norm() < 1e-6F;
    // The weights are refined like positions, and here the head's is 1 at height 1, 0 at -1.
    EXPECT_NEAR(vertex.weights[Role::head], 0.5F * (1 + vertex.position.z()), 1e-6F);
    EXPECT_NEAR(vertex.weights[Role::neck] + vertex.weights[Role::head], 1, 1e-6F);
  }
  EXPECT_EQ(corners, 8);
  EXPECT_EQ(middles, 12);
  EXPECT_EQ(centres, 6);
}

TEST(ControlCage, CoveringsAndOrientationOfFacesAreKept) {
  const ControlCage fine = subdivided(cube());
  int hair = 0;
  for (const ControlCage::Face& face : fine.faces) {
    ASSERT_EQ(face.corners.size(), 4U);
    Vector3f middle = Vector3f::Zero();
    for (const std::uint32_t corner : face.corners) middle += fine.vertices[corner].position / 4;
    const auto at = [&](std::size_t i) { return fine.vertices[face.corners[i]].position; };
    EXPECT_GT((at(2) - at(0)).cross(at(3) - at(1)).dot(middle), 0);  // outward
    hair += face.covering == Covering::hair;
    EXPECT_EQ(face.covering == Covering::hair, middle.z() > 0.6F);
    EXPECT_EQ(face.covering == Covering::shoes, middle.z() < -0.6F);
  }
  EXPECT_EQ(hair, 4);
}

TEST(ControlCage, SubdivisionCommutesWithTurningAndStretching) {
  std::mt19937 random(1);
  const Eigen::Matrix3f map =
      tests::random_rotation(random).toRotationMatrix() * Eigen::Vector3f(0.5F, 2, 1).asDiagonal();
  ControlCage moved = cube();
  for (ControlCage::Vertex& vertex : moved.vertices) vertex.position = map * vertex.position;
  const ControlCage fine = subdivided(subdivided(cube()));
  const ControlCage moved_fine = subdivided(subdivided(moved));
  ASSERT_EQ(fine.vertices.size(), moved_fine.vertices.size());
  for (std::size_t v = 0; v < fine.vertices.size(); ++v) {
    EXPECT_LT((map * fine.vertices[v].position - moved_fine.vertices[v].position).norm(), 1e-5F);
  }
}

}  // namespace
}  // namespace flinch::motion
