// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace flinch::tests {

/// A .glb file, parsed according to the glTF 2.0 specification and independently of the writer's
/// code: nodes, one skin, one animation. Throws std::runtime_error on unexpected content.
struct Glb {
  nlohmann::json document;
  std::string binary;
};

Glb read_glb(std::span<const std::byte> bytes);

/// Returns the numbers of an accessor, element after element; normalised numbers are not converted.
std::vector<double> numbers_of(const Glb& glb, std::size_t accessor);

/// Returns the index of the node with that name.
int node_named(const Glb& glb, const std::string& name);

/// Returns every node's matrix in the scene: at `time_s` in the animation, interpolated between
/// keys as the samplers say, or without it the nodes' own transforms.
std::vector<Eigen::Affine3d> scene_at(const Glb& glb, double time_s);
std::vector<Eigen::Affine3d> scene_at_rest(const Glb& glb);

/// Returns the skinned vertices of a primitive of the first mesh, for these node matrices.
std::vector<Eigen::Vector3d> skinned_positions(const Glb& glb, std::size_t primitive,
                                               const std::vector<Eigen::Affine3d>& nodes);

}  // namespace flinch::tests
