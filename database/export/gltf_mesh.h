// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/export/glb.h"
#include "motion/body.h"

namespace flinch::database {

/// The numbers of vectors, one after the other, as buffers hold them.
template <class Vectors>
std::vector<float> floats_of(const Vectors& vectors) {
  std::vector<float> floats;
  for (const auto& vector : vectors) floats.insert(floats.end(), vector.begin(), vector.end());
  return floats;
}

/// Materials of a character's surface, one per motion::Covering, in their order.
nlohmann::ordered_json figure_materials();
/// The material of a ball, which comes after those.
nlohmann::ordered_json ball_material();

/// A character's skinned surface in glTF's axes, bound in the rest pose: one primitive per
/// covering; all share the vertices.
nlohmann::ordered_json figure_mesh(const motion::Physique& character, GltfBuffer& buffer);
/// A ball, or a rod along X whose axis has this half length, m.
nlohmann::ordered_json ball_mesh(float radius, float half_length, GltfBuffer& buffer);

/// The accessor of transforms from the mesh, in the rest pose, to each joint's frame, whose axes
/// are parallel to the world's there.
int inverse_bind_matrices(const motion::Skeleton& skeleton, GltfBuffer& buffer);

}  // namespace flinch::database
