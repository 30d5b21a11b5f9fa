// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace flinch::motion {

constexpr float radians(float degrees) {
  return degrees * std::numbers::pi_v<float> / 180;
}

constexpr float degrees(float radians) {
  return radians * 180 / std::numbers::pi_v<float>;
}

/// The same angle in [-pi, pi], radians.
inline float wrapped(float angle) {
  return std::remainder(angle, 2 * std::numbers::pi_v<float>);
}

/// Which way a direction points on the ground, radians counter-clockwise from the world's X axis.
inline float yaw_of(const Eigen::Vector3f& direction) {
  return std::atan2(direction.y(), direction.x());
}
/// The same of the X axis of what is turned so.
inline float yaw_of(const Eigen::Quaternionf& orientation) {
  return yaw_of(Eigen::Vector3f(orientation * Eigen::Vector3f::UnitX()));
}

/// The rotation by `angle` radians about a unit axis.
inline Eigen::Quaternionf turn_about(const Eigen::Vector3f& axis, float angle) {
  return Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis));
}

/// v + 2 w (u x v) + 2 u x (u x v) of q = (w, u): Eigen's product, to the bit, without a call.
inline Eigen::Vector3f turned(const Eigen::Vector3f& vector, const Eigen::Quaternionf& by) {
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

/// The rotation by the shortest way that takes one direction to the other; they need not be unit.
/// Opposite ones take a half turn about any axis across them. For floats and doubles.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Vector3<Scalar>& from,
                                           const Eigen::Vector3<Scalar>& to);

/// A rotation seen in a mirror in the X-Z plane: how the right side does what the left does. The
/// axis is mirrored and the sense of rotation turns round.
inline Eigen::Quaternionf mirrored(const Eigen::Quaternionf& rotation) {
  return {rotation.w(), -rotation.x(), rotation.y(), -rotation.z()};
}

/// The rotation vector (axis times angle in [0, pi]) of a unit quaternion, radians.
template <typename Scalar>
Eigen::Vector3<Scalar> rotation_vector(const Eigen::Quaternion<Scalar>& rotation) {
  const Scalar sine = rotation.vec().norm();
  if (!(sine > 0)) return Eigen::Vector3<Scalar>::Zero();
  // atan2 with |w| takes the shorter of the two ways round.
  const Scalar angle = 2 * std::atan2(sine, std::abs(rotation.w()));
  return (rotation.w() < 0 ? -angle : angle) / sine * rotation.vec();
}

/// The rotation of a rotation vector: the inverse.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_by(const Eigen::Vector3<Scalar>& vector) {
  const Scalar angle = vector.norm();
  if (!(angle > 0)) return Eigen::Quaternion<Scalar>::Identity();
  return Eigen::Quaternion<Scalar>(Eigen::AngleAxis<Scalar>(angle, vector / angle));
}

/// A rotation as a swing across a unit axis after a twist about it.
template <typename Scalar>
struct SwingAndTwist {
  Eigen::Quaternion<Scalar> swing;
  Eigen::Quaternion<Scalar> twist;
};
template <typename Scalar>
SwingAndTwist<Scalar> split_at_twist(const Eigen::Quaternion<Scalar>& rotation,
                                     const Eigen::Vector3<Scalar>& axis) {
  const Scalar along = rotation.vec().dot(axis);
  Eigen::Quaternion<Scalar> twist(rotation.w(), along * axis.x(), along * axis.y(),
                                  along * axis.z());
  const Scalar norm = twist.norm();
  // A swing by half a turn leaves no twist to speak of.
  if (norm < 8 * std::numeric_limits<Scalar>::epsilon()) {
    return {rotation, Eigen::Quaternion<Scalar>::Identity()};
  }
  twist.coeffs() /= norm;
  return {rotation * twist.conjugate(), twist};
}

/// The sum of the swing's rotation vector, which is across the axis, and the twist's, which is
/// along it. Radians.
template <typename Scalar>
Eigen::Vector3<Scalar> swing_and_twist(const Eigen::Quaternion<Scalar>& rotation,
                                       const Eigen::Vector3<Scalar>& axis) {
  const auto [swing, twist] = split_at_twist(rotation, axis);
  return rotation_vector(swing) + rotation_vector(twist);
}

/// The rotation that has these angles: the inverse.
template <typename Scalar>
Eigen::Quaternion<Scalar> from_swing_and_twist(const Eigen::Vector3<Scalar>& angles,
                                               const Eigen::Vector3<Scalar>& axis) {
  const Eigen::Vector3<Scalar> twist = angles.dot(axis) * axis;
  return rotation_by<Scalar>(angles - twist) * rotation_by<Scalar>(twist);
}

}  // namespace flinch::motion
