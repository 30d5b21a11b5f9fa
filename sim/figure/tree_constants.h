// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::sim {

/// A figure's joints as plain numbers, for code that steps several figures side by side. Bodies are
/// in the order of motion::Body, parents first. Quaternions are x, y, z, w.
struct TreeConstants {
  static constexpr std::size_t kBodies = 17;
  /// As JointRange.
  struct Range {
    double reference[4] = {}, bone[3] = {}, min[3] = {}, max[3] = {};
  };
  struct Body {
    std::size_t parent = 0;  ///< of the pelvis: itself
    double mass_kg = 0;
    double inertia[6] = {};  ///< xx, yy, zz, xy, xz, yz; about the centre of mass, kg m^2
    double joint[3] = {};    ///< from the centre of mass, in the body's frame, m; pelvis: 0
    int free_axes = 3;       ///< number of the joint's axes with springs; the others are rigid
    double hinge[3] = {};    ///< anatomical axis of a joint with less than three
    double stiffness = 0, damping = 0;  ///< of the joint's springs, as Gains
    int bone = -1;                      ///< coordinate axis of has_bone_axes(), or -1
    bool follows_velocity = true;       ///< as ServoLaw, like the next three
    double twist_share = 1;
    double limit_stiffness = 0, limit_damping = 0;
    Range range;
  };
  Body bodies[kBodies];
};

}  // namespace flinch::sim
