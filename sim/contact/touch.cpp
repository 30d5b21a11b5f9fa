// SPDX-License-Identifier: MIT
#include "sim/contact/touch.h"

#include <numbers>

namespace flinch::sim {
namespace {

constexpr double kFriction = 0.5;           // of ball and body or ground
constexpr double kGroundFrequency_hz = 20;  // of the figure on its feet

}  // namespace

Touch hit_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double restitution) {
  Touch touch;
  touch.point = point;
  touch.normal = normal;
  touch.bounce = restitution;
  touch.friction = kFriction;
  return touch;
}

Touch push_at(const motion::Clearance& at, double free_closing_mps) {
  Touch touch;
  touch.point = at.point;
  touch.normal = at.normal;
  touch.free_closing_mps = free_closing_mps;
  return touch;
}

// A spring k and damper c taken implicitly over a step h (ODE manual, 3.8.2):
//   erp = h k / (h k + c),  cfm = 1 / (h k + c),  with k = m w^2 and c = 2 m w.
Touch support_at(const Eigen::Vector3d& point, double depth_m, double mass_kg, double step_s) {
  const double frequency = 2 * std::numbers::pi * kGroundFrequency_hz;
  const double spring = step_s * mass_kg * frequency * frequency;
  const double damper = 2 * mass_kg * frequency;
  Touch touch;
  touch.point = point;
  touch.depth_m = depth_m;
  touch.error_reduction = spring / (spring + damper);
  touch.softness = 1 / (spring + damper);
  return touch;
}

}  // namespace flinch::sim
