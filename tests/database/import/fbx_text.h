// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/import/bvh.h"

namespace flinch::tests {

/// What an FBX file can say that BVH cannot.
struct FbxSettings {
  int up_axis = 1;              ///< 0, 1 or 2: X, Y or Z
  int up_axis_sign = 1;         ///< -1: its opposite
  double unit_centimetres = 1;  ///< UnitScaleFactor
  /// Of every joint, degrees about X, Y and Z; rotations are then pre * rotation * post^-1.
  Eigen::Vector3d pre_rotation = Eigen::Vector3d::Zero();
  Eigen::Vector3d post_rotation = Eigen::Vector3d::Zero();
  /// Of every joint's mesh, which no joint moves with.
  Eigen::Vector3d geometric_translation = Eigen::Vector3d::Zero();
  Eigen::Vector3d geometric_rotation = Eigen::Vector3d::Zero();  ///< degrees
  int layer_count = 1;                                           ///< the second one turns the root
  int last_rotation_order = 3;     ///< of the last joint; 3 is that of `bvh`, 6 spheric XYZ
  bool is_rotation_active = true;  ///< of the last joint
};

/// Returns the joints and the motion of a BVH file as a minimal FBX file of version 7.4, in text.
/// Its joints must have their rotations in the order Z, X, Y; names must be unique.
std::string fbx_text(const database::Bvh& bvh, const FbxSettings& settings = {});

}  // namespace flinch::tests
