// SPDX-License-Identifier: MIT
#include "sim/figure/support.h"

#include <algorithm>

#include "sim/figure/figure_rows.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kFootContactPoints = 4;
// Of a fallen figure: number of points that share its weight, and how fast the ground stops a part.
constexpr double kFallenContactPoints = 12;
constexpr double kGroundDrag_hz = 10;

/// Heel and toe on the sole's centre line, in the frame of the foot's centre of mass, m. Two points
/// per foot instead of its corners, because each point costs the solver a pivot; the ankle controls
/// the foot's roll.
std::array<Eigen::Vector3d, 2> heel_and_toe(const MovingShape& foot) {
  return {sole_point(foot, -1, 0), sole_point(foot, 1, 0)};
}

/// Points at either end of a part that would touch the ground first; for a box, those of the
/// largest capsule along its longest axis.
std::array<Eigen::Vector3d, 2> lowest_end_points(const MovingShape& shape) {
  double radius = shape.radius;
  Eigen::Vector3d end(0, 0, shape.half_length);
  if (shape.kind == motion::Shape::Kind::box) {
    int longest = 0;
    const double half_length = shape.half_extents.maxCoeff(&longest);
    radius = shape.half_extents.minCoeff();
    end = (half_length - radius) * Eigen::Vector3d::Unit(longest);
  }
  const Eigen::Vector3d low = shape.centre - radius * Eigen::Vector3d::UnitZ();
  return {low + shape.orientation * end, low - shape.orientation * end};
}

Support foot_support(const FigureModel& figure_model, Body foot, const BodyState& now,
                     const BodyState& target) {
  Support support{.points = {}, .count = 0, .mass_kg = figure_model.mass_kg / kFootContactPoints};
  for (const Eigen::Vector3d& end : heel_and_toe(figure_model.outline[foot])) {
    const Eigen::Vector3d point = now.position + now.orientation * end;
    const double ground = std::min(0.0, (target.position + target.orientation * end).z());
    if (point.z() >= ground) continue;
    support.points[support.count++] = {point, ground - point.z()};
  }
  return support;
}

Support fallen_support(const FigureModel& figure_model, Body body, const BodyState& now) {
  Support support{.points = {}, .count = 0, .mass_kg = figure_model.mass_kg / kFallenContactPoints};
  for (const Eigen::Vector3d& point :
       lowest_end_points(placed_shape(figure_model.outline[body], now))) {
    if (point.z() < 0) support.points[support.count++] = {point, -point.z()};
  }
  return support;
}

}  // namespace

Support support_of(const FigureModel& figure_model, Body body, const BodyState& now,
                   const BodyState& target, const Drive& drive, const motion::PerSide<bool>& held) {
  if (drive.is_falling) return fallen_support(figure_model, body, now);
  for (motion::Side side : motion::kSides) {
    if (body == foot_of(side) && !held[side]) return foot_support(figure_model, body, now, target);
  }
  return {};
}

Eigen::Vector3d ground_drag(const FigureModel& figure_model, Body body, const BodyState& now) {
  const double drag = kGroundDrag_hz * static_cast<double>(figure_model.model[body].mass_kg);
  return {-drag * now.velocity.x(), -drag * now.velocity.y(), 0};
}

}  // namespace flinch::sim
