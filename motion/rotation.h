// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

namespace flinch::motion {

template <std::floating_point Scalar>
constexpr Scalar radians(Scalar degrees) {
  return degrees * (std::numbers::pi_v<Scalar> / 180);
}
constexpr float radians(int degrees) {
  return radians(static_cast<float>(degrees));
}

template <std::floating_point Scalar>
constexpr Scalar degrees(Scalar radians) {
  return radians * (180 / std::numbers::pi_v<Scalar>);
}

/// Returns the equivalent angle in [-pi, pi], radians.
template <std::floating_point Scalar>
Scalar wrapped_to_pi(Scalar angle) {
  return std::remainder(angle, 2 * std::numbers::pi_v<Scalar>);
}

/// Returns the yaw of a direction, radians counter-clockwise from the world's X axis.
inline float yaw_of(const Eigen::Vector3f& direction) {
  return std::atan2(direction.y(), direction.x());
}
/// Returns the yaw of an orientation's X axis.
inline float yaw_of(const Eigen::Quaternionf& orientation) {
  return yaw_of(Eigen::Vector3f(orientation * Eigen::Vector3f::UnitX()));
}

/// Returns the rotation by `angle` radians about a unit axis.
inline Eigen::Quaternionf rotation_about(const Eigen::Vector3f& axis, float angle) {
  return Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis));
}

/// Returns v + 2 w (u x v) + 2 u x (u x v) for the rotation (w, u): the same bits as Eigen's
/// product, which compilers do not inline.
inline Eigen::Vector3f rotated(const Eigen::Vector3f& vector, const Eigen::Quaternionf& by) {
  const float x = by.x(), y = by.y(), z = by.z(), w = by.w();
  const auto cross = [=](float a, float b, float c) {
    return std::array{y * c - z * b, z * a - x * c, x * b - y * a};
  };
  auto [a, b, c] = cross(vector.x(), vector.y(), vector.z());
  a += a;
  b += b;
  c += c;
  const auto [d, e, f] = cross(a, b, c);
  return {vector.x() + w * a + d, vector.y() + w * b + e, vector.z() + w * c + f};
}

/// Returns the shortest rotation that takes direction `from` to direction `to`; they need not be
/// unit. For opposite directions it is a half turn about an arbitrary perpendicular axis. For
/// floats and doubles.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Vector3<Scalar>& from,
                                           const Eigen::Vector3<Scalar>& to);

/// Returns the rotation mirrored in the X-Z plane, which exchanges left and right: the axis is
/// mirrored and the direction of rotation is reversed.
inline Eigen::Quaternionf mirrored(const Eigen::Quaternionf& rotation) {
  return {rotation.w(), -rotation.x(), rotation.y(), -rotation.z()};
}

/// Returns the rotation vector (axis times angle in [0, pi]) of a unit quaternion, radians.
template <typename Scalar>
Eigen::Vector3<Scalar> rotation_vector(const Eigen::Quaternion<Scalar>& rotation) {
  const Scalar sine = rotation.vec().norm();
  if (!(sine > 0)) return Eigen::Vector3<Scalar>::Zero();
  // atan2 with |w| takes the shorter of the two ways round.
  const Scalar angle = 2 * std::atan2(sine, std::abs(rotation.w()));
  return (rotation.w() < 0 ? -angle : angle) / sine * rotation.vec();
}

/// Returns the rotation that has this rotation vector: the inverse of rotation_vector().
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_from_vector(const Eigen::Vector3<Scalar>& vector) {
  const Scalar angle = vector.norm();
  if (!(angle > 0)) return Eigen::Quaternion<Scalar>::Identity();
  return Eigen::Quaternion<Scalar>(Eigen::AngleAxis<Scalar>(angle, vector / angle));
}

/// A rotation split into a twist about a unit axis, followed by a swing about a perpendicular one.
template <typename Scalar>
struct SwingTwist {
  Eigen::Quaternion<Scalar> swing;
  Eigen::Quaternion<Scalar> twist;
};
template <typename Scalar>
SwingTwist<Scalar> decompose_swing_twist(const Eigen::Quaternion<Scalar>& rotation,
                                         const Eigen::Vector3<Scalar>& axis) {
  const Scalar along = rotation.vec().dot(axis);
  Eigen::Quaternion<Scalar> twist(rotation.w(), along * axis.x(), along * axis.y(),
                                  along * axis.z());
  const Scalar norm = twist.norm();
  // A swing by half a turn leaves the twist undefined.
  if (norm < 8 * std::numeric_limits<Scalar>::epsilon()) {
    return {rotation, Eigen::Quaternion<Scalar>::Identity()};
  }
  twist.coeffs() /= norm;
  return {rotation * twist.conjugate(), twist};
}

/// Returns the sum of the swing's rotation vector, perpendicular to the axis, and the twist's,
/// along it. Radians.
template <typename Scalar>
Eigen::Vector3<Scalar> swing_twist_vector(const Eigen::Quaternion<Scalar>& rotation,
                                          const Eigen::Vector3<Scalar>& axis) {
  const auto [swing, twist] = decompose_swing_twist(rotation, axis);
  return rotation_vector(swing) + rotation_vector(twist);
}

/// Returns the rotation that has these angles: the inverse of swing_twist_vector().
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_from_swing_twist(const Eigen::Vector3<Scalar>& angles,
                                                    const Eigen::Vector3<Scalar>& axis) {
  const Eigen::Vector3<Scalar> twist = angles.dot(axis) * axis;
  return rotation_from_vector<Scalar>(angles - twist) * rotation_from_vector<Scalar>(twist);
}

}  // namespace flinch::motion
