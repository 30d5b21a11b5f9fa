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

/// A .glb file, read by the specification of glTF 2.0 and not by the writer's code: nodes, one
/// skin, one animation. Throws std::runtime_error on what it does not expect.
struct Glb {
  nlohmann::json document;
  std::string binary;
};

Glb read_glb(std::span<const std::byte> bytes);

/// The numbers of an accessor, element after element; normalised ones as they are.
std::vector<double> numbers_of(const Glb& glb, std::size_t accessor);

/// The index of the node with that name.
int node_named(const Glb& glb, const std::string& name);

/// Every node's matrix in the scene. With `time_s`, as the animation has it then, between keys by
/// its samplers; else as the nodes say.
std::vector<Eigen::Affine3d> scene_at(const Glb& glb, double time_s);
std::vector<Eigen::Affine3d> scene_at_rest(const Glb& glb);

/// The skinned vertices of a primitive of the first mesh, for nodes that are so in the scene.
std::vector<Eigen::Vector3d> skinned_positions(const Glb& glb, std::size_t primitive,
                                               const std::vector<Eigen::Affine3d>& nodes);

}  // namespace flinch::tests
