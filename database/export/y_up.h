// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::database {

/// Converts to the axes that other tools expect, glTF by specification and BVH by custom: Y up, Z
/// forward and X to the character's left. From ours (Z up, X forward, Y left) this is a cyclic
/// permutation, exact in any precision: (x, y, z) becomes (y, z, x).
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> to_y_up(const Eigen::Matrix<Scalar, 3, 1>& vector) {
  return {vector.y(), vector.z(), vector.x()};
}

/// Returns the same rotation about the converted axis.
template <class Scalar>
Eigen::Quaternion<Scalar> to_y_up(const Eigen::Quaternion<Scalar>& rotation) {
  return {rotation.w(), rotation.y(), rotation.z(), rotation.x()};
}

}  // namespace flinch::database
