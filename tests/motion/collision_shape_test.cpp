// SPDX-License-Identifier: MIT
#include "motion/collision_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/motion/random_shapes.h"

namespace flinch::motion {
namespace {

/// Containment by the definition of the shape, independent of the code under test.
bool contains(const CollisionShape& outline, const Eigen::Vector3d& point) {
  const Eigen::Vector3d local = outline.orientation.conjugate() * (point - outline.centre);
  if (outline.kind == Shape::Kind::box) {
    return ((outline.half_extents - local.cwiseAbs()).array() >= 0).all();
  }
  const double along = std::clamp(local.z(), -outline.half_length, outline.half_length);
  return (local - Eigen::Vector3d(0, 0, along)).norm() <= outline.radius;
}

TEST(Clearance, GapIsTheRadiusAtWhichTheBallFirstReachesTheShape) {
  tests::RandomShapes random(11);
  for (int i = 0; i < 300; ++i) {
    const CollisionShape outline = random.outline();
    const Eigen::Vector3d centre = random.vector(0.8);
    const Clearance near = clearance(centre, 0, outline);
    EXPECT_EQ(gap(centre, 0, outline), near.gap);
    if (near.gap <= 0) {
      EXPECT_TRUE(contains(outline, centre));
      continue;
    }
    EXPECT_FALSE(contains(outline, centre));
    EXPECT_NEAR((centre - near.point).norm(), near.gap, 1e-12);
    EXPECT_TRUE(contains(outline, near.point - 1e-9 * near.normal));
    // No point of a ball with slightly less than that radius is in the outline.
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d inside = 0.999 * near.gap * random.vector(1).normalized();
      EXPECT_FALSE(contains(outline, centre + inside));
    }
  }
}

// Half of the segments pass through the outline's middle, where the deepest place counts.
TEST(NearestShare, NoOtherPlaceOfASegmentIsNearer) {
  tests::RandomShapes random(12);
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const CollisionShape outline = random.outline();
    const Eigen::Vector3d from = random.vector(0.8);
    const Eigen::Vector3d far = random.vector(0.8);
    const Eigen::Vector3d to =
        i % 2 == 0 ? far : Eigen::Vector3d(outline.centre + 1.2 * (outline.centre - from));
    const double share = nearest_share(from, to, outline);
    ASSERT_GE(share, 0);
    ASSERT_LE(share, 1);
    const double found = gap(from + share * (to - from), 0, outline);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, gap(from + k / 2000.0 * (to - from), 0, outline));
    EXPECT_LE(found, least + 1e-9) << i;
    inside += found < 0;
  }
  EXPECT_GT(inside, 100);
}

TEST(Clearance, InsideABoxUsesTheNearestFace) {
  CollisionShape box;
  box.kind = Shape::Kind::box;
  box.half_extents = {0.3, 0.2, 0.1};
  const Clearance near = clearance({0.05, 0.05, -0.08}, 0.01, box);
  EXPECT_NEAR(near.gap, -0.03, 1e-12);
  EXPECT_TRUE(near.normal.isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(near.point.isApprox(Eigen::Vector3d(0.05, 0.05, -0.1)));
}

}  // namespace
}  // namespace flinch::motion
