// SPDX-License-Identifier: MIT
#include "motion/rotation.h"

namespace flinch::motion {

// Not in the header: for opposite directions Eigen uses a singular value decomposition, which costs
// ten seconds of compile time.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Vector3<Scalar>& from,
                                           const Eigen::Vector3<Scalar>& to) {
  return Eigen::Quaternion<Scalar>::FromTwoVectors(from, to);
}

template Eigen::Quaternionf rotation_between(const Eigen::Vector3f& from,
                                             const Eigen::Vector3f& to);
template Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from,
                                             const Eigen::Vector3d& to);

}  // namespace flinch::motion
