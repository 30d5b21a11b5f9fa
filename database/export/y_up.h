// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::database {

/// The axes that other tools expect, glTF by its specification and BVH by custom: Y up, Z forward
/// and X to the character's left. From ours (Z up, X forward, Y left) that is a cyclic exchange,
/// exact in any precision: (x, y, z) becomes (y, z, x).
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> to_y_up(const Eigen::Matrix<Scalar, 3, 1>& vector) {
  return {vector.y(), vector.z(), vector.x()};
}

/// The same rotation about the exchanged axis.
template <class Scalar>
Eigen::Quaternion<Scalar> to_y_up(const Eigen::Quaternion<Scalar>& rotation) {
  return {rotation.w(), rotation.y(), rotation.z(), rotation.x()};
}

}  // namespace flinch::database
