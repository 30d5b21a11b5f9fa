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
  std::vector<Eigen::Vector3f> normals;                 ///< unit, outward; one per position
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
};

/// Returns the surface of all points within `radius` (above 0) of a box centred at the origin with
/// half extents `core` (0 or more): a sphere if all three are 0, a capsule if only one is not,
/// otherwise a box with rounded edges and corners. `segments` (at least 1) is the number of chords
/// per quarter circle.
Mesh rounded_solid(const Eigen::Vector3f& core, float radius, int segments);

/// Appends `part` to `whole`, first rotated, then translated.
void append(const Mesh& part, const Eigen::Quaternionf& orientation, const Eigen::Vector3f& centre,
            Mesh& whole);

}  // namespace flinch::database
