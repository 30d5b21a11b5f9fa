// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "motion/skeleton.h"

namespace flinch::database {

/// The grid on which the poses of authored and imported clips lie. Files hold the numbers of grid
/// points, so they give back every bit of such a pose.
///
/// Of a root, each coordinate is a multiple of 2^-15 m. Of a rotation, three components are
/// multiples of 2^-b, with b by role below, and the fourth makes it unit. The nearer a joint is to
/// the pelvis, the more of the body its error moves, and the finer is its grid.
inline constexpr int kRootBits = 15;
inline constexpr motion::PerRole<int> kRotationBits{
    16, 16, 16, 15, 14,  // pelvis, abdomen, chest, neck, head
    16, 15, 15, 14,      // clavicle, upper arm, forearm, hand
    16, 15, 15, 14,      //
    16, 15, 14, 14,      // thigh, shin, foot, toes
    16, 15, 14, 14,
};

/// A power of two, so that products with it and with its inverse are exact.
inline float steps_per_unit(int bits) {
  return static_cast<float>(1 << bits);
}

/// The components of a rotation in the order of files: w x y z.
using Components = std::array<float, 4>;

inline Components components_of(const Eigen::Quaternionf& rotation) {
  return {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
}
inline Eigen::Quaternionf rotation_of(const Components& components) {
  return {components[0], components[1], components[2], components[3]};
}

/// Which component of a rotation makes it unit, and its sign. Files hold the number
/// component + 4 if negative.
struct DerivedComponent {
  unsigned component = 0;  ///< 0 to 3
  bool is_negative = false;
};
inline constexpr unsigned kDerivedCount = 8;

constexpr DerivedComponent derived_component(unsigned code) {
  return {code & 3U, (code & 4U) != 0};
}

/// The square of the component that makes a rotation with these three others unit: below 0 if they
/// are longer than 1. Exact for components on the grid, so every compiler gives the same bits.
inline double derived_square(float a, float b, float c) {
  const double x = a, y = b, z = c;
  return 1 - (x * x + y * y + z * z);
}

/// Its magnitude; not-a-number if the others are longer than 1.
inline float derived_magnitude(float a, float b, float c) {
  return static_cast<float>(std::sqrt(derived_square(a, b, c)));
}

/// Makes 0 of every -0, which no grid point has.
inline void make_zeros_positive(motion::Pose& pose) {
  pose.root_position.array() += 0.0F;
  for (Eigen::Quaternionf& rotation : pose.rotation) rotation.coeffs().array() += 0.0F;
}

}  // namespace flinch::database
