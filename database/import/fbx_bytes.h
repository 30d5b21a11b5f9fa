// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flinch::database {

// What an FBX file says, in text or in binary, and Assimp 5.2.5 does not tell. It is found in the
// bytes by the names that every such file has for it, without a reader of the whole format.

/// Whether the file has more animation layers than stacks of them.
bool has_animation_layers(std::string_view bytes);

/// What a node of the file says of its rotations, or else the defaults of all nodes.
struct FbxRotationRules {
  std::string name;             ///< see printable_text; empty for the defaults
  double order = 0;             ///< 0 to 5 for Euler angles, XYZ first; 6 is "spheric XYZ"
  bool is_active = false;       ///< whether the order and the rotations beside it count
  bool is_turned_else = false;  ///< has a pre- or post-rotation that is not 0

  bool has_euler_order() const { return order >= 0 && order <= 5; }
};

/// Returns the rules of all nodes in the file's order; the first are the defaults. A property that
/// is cut or of another form than FBX has is passed over.
std::vector<FbxRotationRules> fbx_rotation_rules(std::string_view bytes);

}  // namespace flinch::database
