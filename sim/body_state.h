// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace flinch::sim {

/// Pose and velocity of a rigid body at its centre of mass. World frame.
struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< rad/s
};

/// Linear and angular velocity of a body at its centre of mass, m/s and rad/s; or an impulse and
/// its moment there, N·s and N·m·s. World.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

/// Returns the body `time_s` later if it keeps its velocities, as a step moves it: x' = x + h v,
/// and q' is q + h/2 w q normalised.
inline BodyState moved_on(BodyState body, double time_s) {
  const Eigen::Quaterniond spin(0, body.angular_velocity.x(), body.angular_velocity.y(),
                                body.angular_velocity.z());
  body.position += time_s * body.velocity;
  body.orientation.coeffs() += time_s / 2 * (spin * body.orientation).coeffs();
  body.orientation.normalize();
  return body;
}

/// Returns the velocity of the body's material point that is at `point` (world, m), m/s.
inline Eigen::Vector3d velocity_at(const BodyState& body, const Eigen::Vector3d& point) {
  return body.velocity + body.angular_velocity.cross(point - body.position);
}

}  // namespace flinch::sim
