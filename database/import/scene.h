// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace flinch::database {

/// The keys of one node's motion, each track in the order of time; an empty track keeps the node's
/// own value.
struct SceneTrack {
  std::vector<double> position_times_s, rotation_times_s, scale_times_s;
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Quaterniond> rotations;
  std::vector<Eigen::Vector3d> scales;
};

/// A node of a scene.
struct SceneNode {
  std::string name;  ///< see printable_text
  int parent = -1;   ///< index into Scene::nodes, above this one; -1 for the first
  Eigen::Affine3d local = Eigen::Affine3d::Identity();  ///< relative to the parent, without motion
  bool is_bone = false;                                 ///< of a mesh's skin
  bool has_mesh = false;                                ///< what is seen, unless it is a bone
  bool is_helper = false;    ///< part of another node's transform, such as an FBX pre-rotation
  bool is_animated = false;  ///< itself, or by one of its helpers
  SceneTrack track;
};

/// The nodes and one animation of an FBX or glTF file, in metres, Y up: glTF is so by definition,
/// an FBX file says its unit and up axis.
struct Scene {
  std::string path;              ///< for messages
  std::vector<SceneNode> nodes;  ///< parents first, depth first; the first one is the world
  std::vector<std::string> warnings;
};

/// Reads an FBX or glTF file with Assimp, of which only these two readers are used. Other files
/// that it refers to are read only from its own folder and those below. Of several animations,
/// takes the longest, and of several animation layers does not take the sum, each with a warning;
/// rotations of FBX that are switched off are read, with a warning. Throws Error for a file that
/// cannot be read, is larger than 256 MiB with all that it refers to, has no animation, several
/// nodes with the name of one that moves, a rotation order that is not one of Euler angles, numbers
/// that are not finite or keys out of order.
Scene read_scene(const std::string& path);

}  // namespace flinch::database
