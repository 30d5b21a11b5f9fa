// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::database {

/// Returns angles (a, b, c), radians, with Rz(a) Rx(b) Ry(c) = `rotation` (unit). Of the two
/// solutions and their multiples of a full turn, returns the one nearest to `near`, so that curves
/// are continuous from key to key. Where b is within 1e-6 of a quarter turn, a and c rotate about
/// the same axis, and a is that of `near`. The product equals the rotation to 1e-6 everywhere.
Eigen::Vector3d euler_zxy(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near);

}  // namespace flinch::database
