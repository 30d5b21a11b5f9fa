// SPDX-License-Identifier: MIT
#include "sim/contact/contact_constraint.h"

#include <cmath>
#include <numbers>

namespace flinch::sim {
namespace {

constexpr double kGroundFrequency_hz = 20;  // of the ground spring under the feet

/// Returns a unit vector perpendicular to a unit vector.
Eigen::Vector3d across(const Eigen::Vector3d& normal) {
  const bool upright = std::abs(normal.z()) > std::sqrt(0.5);
  return (upright ? Eigen::Vector3d(0, -normal.z(), normal.y())
                  : Eigen::Vector3d(-normal.y(), normal.x(), 0))
      .normalized();
}

// Bullet, PhysX, Rapier and ReactPhysics3D take the velocity of sliding too, some without the spin
// of the bodies, and a direction that is fixed in the world where nothing slides. That last would
// let a contact which is about to slide depend on where the scene faces.
Eigen::Vector3d friction_direction(const Eigen::Vector3d& normal,
                                   const Eigen::Vector3d& relative_velocity,
                                   const Eigen::Quaterniond& frame) {
  const Eigen::Vector3d sliding = relative_velocity - relative_velocity.dot(normal) * normal;
  const double speed = sliding.norm();
  return speed > kMinSlidingSpeed_mps ? Eigen::Vector3d(sliding / speed)
                                      : Eigen::Vector3d(frame * across(frame.conjugate() * normal));
}

}  // namespace

ContactConstraint impact_constraint(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    const BodyState& ball, const BodyState& part,
                                    const features::Bounce& bounce) {
  ContactConstraint constraint;
  constraint.point = point;
  constraint.normal = normal;
  constraint.tangent = friction_direction(
      normal, velocity_at(ball, point) - velocity_at(part, point), part.orientation);
  constraint.restitution = bounce.restitution;
  constraint.friction = bounce.friction;
  return constraint;
}

ContactConstraint bounce_constraint(const BodyState& ball, const Eigen::Quaterniond& frame,
                                    const features::Bounce& bounce) {
  BodyState ground;
  ground.orientation = frame;
  return impact_constraint({ball.position.x(), ball.position.y(), 0}, Eigen::Vector3d::UnitZ(),
                           ball, ground, bounce);
}

ContactConstraint body_contact_constraint(const motion::Clearance& at, double free_closing_mps) {
  ContactConstraint constraint;
  constraint.point = at.point;
  constraint.normal = at.normal;
  constraint.free_closing_mps = free_closing_mps;
  return constraint;
}

// A spring k and damper c integrated implicitly over a step h (ODE manual, 3.8.2):
//   erp = h k / (h k + c),  cfm = 1 / (h k + c),  with k = m w^2 and c = 2 m w.
ContactConstraint ground_constraint(const Eigen::Vector3d& point, double depth_m, double mass_kg,
                                    double step_s) {
  const double frequency = 2 * std::numbers::pi * kGroundFrequency_hz;
  const double spring = step_s * mass_kg * frequency * frequency;
  const double damper = 2 * mass_kg * frequency;
  ContactConstraint constraint;
  constraint.point = point;
  constraint.depth_m = depth_m;
  constraint.error_reduction = spring / (spring + damper);
  constraint.softness = 1 / (spring + damper);
  return constraint;
}

}  // namespace flinch::sim
