// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/figure/drive.h"
#include "sim/figure/figure_model.h"

namespace flinch::sim {

/// A point of a part at which the ground supports it.
struct SupportPoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< world, m
  double depth_m = 0;                               ///< below the ground's surface
};

/// The ground's support of a body: the first `count` of `points`.
struct Support {
  std::array<SupportPoint, 2> points;
  std::size_t count = 0;
  double mass_kg = 0;  ///< the mass that each point carries; see ground_constraint
};

/// The bodies that may have support.
constexpr BodySet supported_bodies(const Drive& drive) {
  return drive.is_falling ? kAllBodies
                          : set_of(motion::Body::left_foot) | set_of(motion::Body::right_foot);
}

/// Returns the support of a body in a step that ends at `target`: of feet that nothing else holds,
/// at heel and toe, or of every part of a figure that falls. Where the reference itself sinks a
/// sole into the ground, the ground gives way by that depth, so that an error of the recording does
/// not become a force.
Support support_of(const FigureModel& figure_model, motion::Body body, const BodyState& now,
                   const BodyState& target, const Drive& drive, const motion::PerSide<bool>& held);

/// Returns the force with which the ground slows a supported part of a figure that falls, N:
/// viscous damping in place of friction, which would cost the solver two bounded rows per point.
Eigen::Vector3d ground_drag(const FigureModel& figure_model, motion::Body body,
                            const BodyState& now);

}  // namespace flinch::sim
