// SPDX-License-Identifier: MIT
#include "database/export/solid_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "tests/motion/random_motion.h"

namespace flinch::database {
namespace {

using Eigen::Vector3f;

const Vector3f kCores[] = {
    {0, 0, 0}, {0, 0, 0.3F}, {0, 0.2F, 0}, {0.1F, 0.2F, 0}, {0.1F, 0.2F, 0.3F}};

// Sum of the tetrahedra from the origin to each triangle; positive if they are wound outwards.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.positions[a].cross(mesh.positions[b]).dot(mesh.positions[c]) / 6;
  }
  return sum;
}

// Steiner's formula: the volume of all points within r of a box with half extents a, b, c.
double volume_within(const Vector3f& core, float r) {
  const double a = core.x();
  const double b = core.y();
  const double c = core.z();
  return 8 * a * b * c + 8 * r * (a * b + b * c + c * a) +
         2 * std::numbers::pi * r * r * (a + b + c) + 4.0 / 3 * std::numbers::pi * r * r * r;
}

TEST(SolidMesh, IsClosedWithoutDegenerateTriangles) {
  for (const Vector3f& core : kCores) {
    const Mesh mesh = rounded_solid(core, 0.1F, 5);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& [a, b, c] : mesh.triangles) {
      for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[edge];
      const Vector3f cross =
          (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
      EXPECT_GT(cross.norm(), 1e-6F);
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << core.transpose();
    }
    // Euler's formula for a closed surface without holes.
    EXPECT_EQ(mesh.positions.size() + mesh.triangles.size(), edges.size() / 2 + 2);
  }
}

TEST(SolidMesh, VolumeMatchesTheSolid) {
  for (const Vector3f& core : kCores) {
    const double expected = volume_within(core, 0.1F);
    const double found = volume(rounded_solid(core, 0.1F, 24));
    EXPECT_LT(found, expected);  // its corners are on the surface
    EXPECT_GT(found, 0.997 * expected) << core.transpose();
  }
}

TEST(SolidMesh, VerticesLieOnTheSurfaceAndNormalsPointAwayFromTheCore) {
  for (const Vector3f& core : kCores) {
    const Mesh mesh = rounded_solid(core, 0.1F, 6);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vector3f nearest = mesh.positions[i].cwiseMax(-core).cwiseMin(core);
      EXPECT_LT((mesh.positions[i] - nearest - 0.1F * mesh.normals[i]).norm(), 1e-6F);
      EXPECT_NEAR(mesh.normals[i].norm(), 1, 1e-6F);
    }
  }
}

TEST(SolidMesh, AppendedPartsKeepTheirShapeWhereTheyAreMoved) {
  std::mt19937 random(3);
  Mesh whole;
  double sum = 0;
  for (const Vector3f& core : kCores) {
    const Mesh part = rounded_solid(core, 0.1F, 4);
    append(part, tests::random_rotation(random), tests::random_vector(random, 1), whole);
    sum += volume(part);
  }
  EXPECT_NEAR(volume(whole), sum, 1e-5 * sum);
  for (const Vector3f& normal : whole.normals) EXPECT_NEAR(normal.norm(), 1, 1e-6F);
}

}  // namespace
}  // namespace flinch::database
