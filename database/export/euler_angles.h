// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::database {

/// Angles (a, b, c), radians, with Rz(a) Rx(b) Ry(c) = `rotation` (unit): of the two triples that
/// give it, and their multiples of a full turn, the one nearest to `near`, so that curves run on
/// from key to key. Within 1e-6 of a quarter turn of b, where a and c turn about the same axis, a
/// stays as in `near`. The product is the rotation to 1e-6 everywhere.
Eigen::Vector3d euler_zxy(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near);

}  // namespace flinch::database
