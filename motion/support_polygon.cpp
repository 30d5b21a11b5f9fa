// SPDX-License-Identifier: MIT
#include "motion/support_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/segment.h"

namespace flinch::motion {
namespace {

// Outline of the left sole: coordinates forward from the heel's end and to the left of the line
// from heel to toe tip, as fractions of the foot's length, counter-clockwise. Shaped after mean
// adult footprints (breadth of the heel 0.25 and of the ball 0.38 of the length, the ball's outer
// joint behind its inner one).
struct SolePoint {
  float forward;
  float left;
};
constexpr std::array<SolePoint, 8> kFootOutline{{{0.00F, -0.040F},
                                                 {0.03F, -0.095F},
                                                 {0.15F, -0.125F},
                                                 {0.73F, -0.190F},
                                                 {0.63F, 0.190F},
                                                 {0.15F, 0.125F},
                                                 {0.03F, 0.095F},
                                                 {0.00F, 0.040F}}};
constexpr std::array<SolePoint, 6> kToesOutline{{{0.73F, -0.190F},
                                                 {0.93F, -0.180F},
                                                 {1.00F, -0.100F},
                                                 {0.98F, 0.000F},
                                                 {0.82F, 0.170F},
                                                 {0.63F, 0.190F}}};

template <std::size_t size>
std::vector<Eigen::Vector3f> outline_in_frame(const std::array<SolePoint, size>& outline,
                                              const FootDimensions& foot, Side side,
                                              const Eigen::Vector3f& frame_origin) {
  const Eigen::Vector3f leftward = Eigen::Vector3f::UnitZ().cross(foot.forward);
  const float sense = side == Side::left ? 1.0F : -1.0F;
  std::vector<Eigen::Vector3f> points;
  points.reserve(size);
  for (const SolePoint& point : outline) {
    points.push_back(foot.heel - frame_origin +
                     foot.length * (point.forward * foot.forward + sense * point.left * leftward));
  }
  if (side == Side::right) std::reverse(points.begin(), points.end());
  return points;
}

// Twice the area of the triangle a b c: positive where it turns left.
float twice_signed_area(const Eigen::Vector2f& a, const Eigen::Vector2f& b,
                        const Eigen::Vector2f& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool precedes(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace

// Andrew's monotone chain (1979): lower hull from left to right, then upper hull back.
std::vector<Eigen::Vector2f> convex_hull(std::vector<Eigen::Vector2f> points) {
  std::sort(points.begin(), points.end(), precedes);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2f> hull;
  const auto add = [&hull](const Eigen::Vector2f& point, std::size_t settled) {
    while (hull.size() > settled &&
           twice_signed_area(hull[hull.size() - 2], hull.back(), point) <= 0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Eigen::Vector2f& point : points) add(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  hull.pop_back();  // repeats the first point
  return hull;
}

SoleOutline sole_outline(const Skeleton& skeleton, Side side) {
  const FootDimensions foot = measure_foot(skeleton, side);
  const Eigen::Vector3f& toes = skeleton.offset[roles_of(side).toes];
  return {outline_in_frame(kFootOutline, foot, side, Eigen::Vector3f::Zero()),
          outline_in_frame(kToesOutline, foot, side, toes)};
}

PerSide<SoleOutline> sole_outlines(const Skeleton& skeleton) {
  return {sole_outline(skeleton, Side::left), sole_outline(skeleton, Side::right)};
}

std::vector<Eigen::Vector3f> sole_points(const SoleOutline& sole, const JointFrames& frames,
                                         Side side) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(sole.foot.size() + sole.toes.size());
  const auto add = [&](const std::vector<Eigen::Vector3f>& outline, Role role) {
    for (const Eigen::Vector3f& point : outline)
      points.push_back(frames.position[role] + frames.orientation[role] * point);
  };
  const FootRoles roles = roles_of(side);
  add(sole.foot, roles.foot);
  add(sole.toes, roles.toes);
  return points;
}

float lowest_z(std::span<const Eigen::Vector3f> points) {
  float lowest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& point : points) lowest = std::min(lowest, point.z());
  return lowest;
}

std::vector<Eigen::Vector2f> support_polygon(const Skeleton& skeleton, const JointFrames& frames,
                                             float tolerance_m) {
  std::vector<Eigen::Vector2f> touching;
  for (Side side : kSides) {
    for (const Eigen::Vector3f& point : sole_points(sole_outline(skeleton, side), frames, side))
      if (point.z() <= tolerance_m) touching.emplace_back(point.head<2>());
  }
  return convex_hull(std::move(touching));
}

float signed_distance_inside(const std::vector<Eigen::Vector2f>& polygon,
                             const Eigen::Vector2f& point) {
  float squared_distance = std::numeric_limits<float>::infinity();
  bool inside = polygon.size() > 2;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f& from = polygon[i];
    const Eigen::Vector2f& to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    squared_distance =
        std::min(squared_distance, (nearest_on_segment(from, to, point) - point).squaredNorm());
    inside = inside && twice_signed_area(from, to, point) >= 0;
  }
  const float distance = std::sqrt(squared_distance);
  return inside ? distance : -distance;
}

// Inside of a convex polygon the nearest edge is the one whose line is nearest. A line's distance
// d changes linearly along the way, from d0 at the point to d1 at the goal, so that it reaches the
// margin m at the fraction (m - d0) / (d1 - d0).
float fraction_to_inside(float margin, const std::vector<Eigen::Vector2f>& polygon,
                         const Eigen::Vector2f& point, const Eigen::Vector2f& goal) {
  float fraction = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f& from = polygon[i];
    const Eigen::Vector2f& to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const float length = (to - from).norm();
    const float at_point = twice_signed_area(from, to, point) / length;
    const float at_goal = twice_signed_area(from, to, goal) / length;
    if (at_goal < margin) return 1;
    if (at_point < margin)
      fraction = std::max(fraction, (margin - at_point) / (at_goal - at_point));
  }
  return fraction;
}

}  // namespace flinch::motion
