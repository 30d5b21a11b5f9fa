// SPDX-License-Identifier: MIT
#include "motion/rotation.h"

namespace flinch::motion {

namespace {

/// Returns a unit vector across a unit vector.
template <typename Scalar>
Eigen::Vector3<Scalar> any_perpendicular(const Eigen::Vector3<Scalar>& direction) {
  Eigen::Index smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  return direction.cross(Eigen::Vector3<Scalar>::Unit(smallest)).normalized();
}

}  // namespace

// Unit vectors a and b at angle t, with c = a . b = cos t: the rotation is (cos t/2, n sin t/2)
// about n = (a x b) / sin t. As 2 cos(t/2) = sqrt(2 + 2 c) = s and sin t = 2 sin(t/2) cos(t/2), its
// parts are s / 2 and (a x b) / s.
//
// Near opposite directions 2 + 2 c cancels. There the sum and the difference do not: |a + b| / 2 =
// cos t/2 and |b - a| / 2 = sin t/2. The axis is perpendicular to d = b - a; the part of a x b
// along d is rounding and is removed. If all of a x b is rounding, any axis perpendicular to d will
// do.
//
// Not Eigen's FromTwoVectors(): the decomposition that it uses for opposite directions takes ten
// seconds of compile time for each type, and within a degree of them its floats are wrong in the
// third digit.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Vector3<Scalar>& from,
                                           const Eigen::Vector3<Scalar>& to) {
  const Eigen::Vector3<Scalar> a = from.normalized();
  const Eigen::Vector3<Scalar> b = to.normalized();
  const Scalar cosine = b.dot(a);
  const Eigen::Vector3<Scalar> cross = a.cross(b);
  Eigen::Quaternion<Scalar> rotation;
  if (cosine < Scalar(-0.9)) {
    const Eigen::Vector3<Scalar> difference = (b - a).normalized();
    Eigen::Vector3<Scalar> axis = any_perpendicular(difference);
    if (cross.norm() > 4 * std::numeric_limits<Scalar>::epsilon()) {
      axis = (cross - difference.dot(cross) * difference).normalized();
    }
    rotation.w() = (a + b).norm() / 2;
    rotation.vec() = (b - a).norm() / 2 * axis;
    return rotation;
  }
  const Scalar s = std::sqrt((1 + cosine) * 2);
  const Scalar inverse = 1 / s;
  rotation.vec() = cross * inverse;
  rotation.w() = s * Scalar(0.5);
  return rotation;
}

template Eigen::Quaternionf rotation_between(const Eigen::Vector3f& from,
                                             const Eigen::Vector3f& to);
template Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from,
                                             const Eigen::Vector3d& to);

}  // namespace flinch::motion
