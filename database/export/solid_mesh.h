// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace flinch::database {

/// A closed surface of triangles.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;               ///< m
  std::vector<Eigen::Vector3f> normals;                 ///< unit, outward; one a position
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
};

/// All points within `radius` (above 0) of a box about the origin with half extents `core` (0 or
/// more): a sphere if all three are 0, a capsule along the one that is not, else a box with rounded
/// edges and corners. A quarter of a circle is drawn with `segments` (at least 1) chords.
Mesh rounded_solid(const Eigen::Vector3f& core, float radius, int segments);

/// Adds `part`, turned and then moved, to `whole`.
void append(const Mesh& part, const Eigen::Quaternionf& orientation, const Eigen::Vector3f& centre,
            Mesh& whole);

}  // namespace flinch::database
