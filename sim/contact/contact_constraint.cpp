// SPDX-License-Identifier: MIT
#include "sim/contact/contact_constraint.h"

#include <numbers>

namespace flinch::sim {
namespace {

constexpr double kFriction = 0.5;           // between ball and body or ground
constexpr double kGroundFrequency_hz = 20;  // of the ground spring under the feet

}  // namespace

ContactConstraint impact_constraint(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    double restitution) {
  ContactConstraint constraint;
  constraint.point = point;
  constraint.normal = normal;
  constraint.restitution = restitution;
  constraint.friction = kFriction;
  return constraint;
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
