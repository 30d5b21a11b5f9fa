// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>

#include "database/import/bvh.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::tests {

/// What a glTF file can say that BVH cannot.
struct GltfSettings {
  double armature_scale = 1;  ///< of a node above the root, which lengths below make up for
  std::string interpolation = "LINEAR";
  int key_step = 1;               ///< every how many frames have keys; the last one has
  std::set<std::string> still{};  ///< joints without channels
  int skin_count = 0;             ///< the skins share the joints in turn
  bool has_ball = false;          ///< a mesh that flies for 20 s
  bool has_bind_pose = false;     ///< an animation of length 0 before the other
  std::map<std::string, std::string> renamed{};  ///< joints with other names in the file
};

/// Writes the joints and the motion of a BVH file in centimetres into the folder, as a glTF file
/// in text and its numbers, and returns its path.
std::string write_gltf(const TemporaryFolder& folder, const database::Bvh& bvh,
                       const GltfSettings& settings = {});

}  // namespace flinch::tests
