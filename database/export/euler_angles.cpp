// SPDX-License-Identifier: MIT
#include "database/export/euler_angles.h"

#include <cmath>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::database {
namespace {

// limit of cos b: far above rounding errors of floats, far below what is visible
constexpr double kLocked = 1e-6;

// Adds full turns to each angle to bring it nearest to `near`.
Eigen::Vector3d unwrapped(const Eigen::Vector3d& angles, const Eigen::Vector3d& near) {
  return angles.binaryExpr(
      near, [](double angle, double old) { return old + motion::wrapped_to_pi(angle - old); });
}

}  // namespace

//                 ( .      -sin a cos b   .           )
//   Rz Rx Ry  =   ( .       cos a cos b   .           )
//                 ( .       sin b         .           )
//
// gives a and b. c follows from Ry = (Rz Rx)^T R, which is exact however near b is to a quarter
// turn. The other solution is (a + pi, pi - b, c + pi).
Eigen::Vector3d euler_zxy(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near) {
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  const double cos_b = std::hypot(matrix(0, 1), matrix(1, 1));
  const double a = cos_b < kLocked ? near[0] : std::atan2(-matrix(0, 1), matrix(1, 1));
  const double b = std::atan2(matrix(2, 1), cos_b);
  const Eigen::Matrix3d rest = (Eigen::AngleAxisd(a, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(b, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix()
                                   .transpose() *
                               matrix;
  const double c = std::atan2(rest(0, 2), rest(0, 0));

  const Eigen::Vector3d one = unwrapped({a, b, c}, near);
  const Eigen::Vector3d other =
      unwrapped({a + std::numbers::pi, std::numbers::pi - b, c + std::numbers::pi}, near);
  return (other - near).squaredNorm() < (one - near).squaredNorm() ? other : one;
}

}  // namespace flinch::database
