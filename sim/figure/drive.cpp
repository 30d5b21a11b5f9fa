// SPDX-License-Identifier: MIT
#include "sim/figure/drive.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kMaxStandingHeight_m = 0.02;
constexpr double kMaxStandingSpeed_mps = 0.15;

bool stands(const BodyState& foot, const MovingShape& outline) {
  if (foot.velocity.norm() > kMaxStandingSpeed_mps) return false;
  const Eigen::Quaterniond turn = foot.orientation * outline.orientation;
  const Eigen::Vector3d centre = foot.position + foot.orientation * outline.centre;
  // The lowest corner: the sum of the half extents' downward components.
  const Eigen::Vector3d down = turn.conjugate() * Eigen::Vector3d::UnitZ();
  return centre.z() - down.cwiseAbs().dot(outline.half_extents) < kMaxStandingHeight_m;
}

/// L = R I R^T w
Eigen::Vector3d angular_momentum(const Eigen::Matrix3d& inertia, const BodyState& state) {
  const Eigen::Vector3d local = state.orientation.conjugate() * state.angular_velocity;
  return state.orientation * (inertia * local);
}

}  // namespace

motion::PerSide<bool> held_feet(const FigureModel& figure_model, const ReferenceState& target,
                                const Drive& drive) {
  motion::PerSide<bool> held{};
  if (drive.is_falling || drive.foot_hold <= 0) return held;
  for (motion::Side side : motion::kSides) {
    const Body foot = foot_of(side);
    held[side] = stands(target.body[foot], figure_model.outline[foot]);
  }
  return held;
}

// m (v_1 - v_0) and L_1 - L_0, so that the joints carry no load (d'Alembert's principle).
Twist feedforward_impulse(const FigureModel& figure_model, Body body, const BodyState& from,
                          const BodyState& to) {
  const double mass_kg = static_cast<double>(figure_model.model[body].mass_kg);
  const Eigen::Matrix3d& inertia = figure_model.inertia[body];
  return {mass_kg * (to.velocity - from.velocity),
          angular_momentum(inertia, to) - angular_momentum(inertia, from)};
}

}  // namespace flinch::sim
