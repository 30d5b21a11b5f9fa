// SPDX-License-Identifier: MIT
#include "motion/support_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flinch::motion {
namespace {

// The left sole's outline: forward from the heel's end and leftward of the line from heel to toe
// tip, as fractions of the foot's length, counter-clockwise. Drawn after mean adult footprints
// (breadth of the heel 0.25 and of the ball 0.38 of the length, the ball's outer joint behind its
// inner one).
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
                                              const FootMeasures& foot, Side side,
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
float turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool before(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

const Eigen::Vector2f& next_corner(const std::vector<Eigen::Vector2f>& polygon, std::size_t i) {
  return polygon[i + 1 < polygon.size() ? i + 1 : 0];
}

float squared_distance_to_segment(const Eigen::Vector2f& from, const Eigen::Vector2f& to,
                                  const Eigen::Vector2f& point) {
  const Eigen::Vector2f edge = to - from;
  const float squared_length = edge.squaredNorm();
  const float along =
      squared_length > 0 ? std::clamp(edge.dot(point - from) / squared_length, 0.0F, 1.0F) : 0;
  return (from + along * edge - point).squaredNorm();
}

}  // namespace

// Andrew's monotone chain (1979): lower hull from left to right, then upper hull back.
std::vector<Eigen::Vector2f> convex_hull(std::vector<Eigen::Vector2f> points) {
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2f> hull;
  const auto add = [&hull](const Eigen::Vector2f& point, std::size_t settled) {
    while (hull.size() > settled && turn(hull[hull.size() - 2], hull.back(), point) <= 0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Eigen::Vector2f& point : points) add(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  hull.pop_back();  // the first point again
  return hull;
}

SoleOutline sole_outline(const Skeleton& skeleton, Side side) {
  const FootMeasures foot = measure_foot(skeleton, side);
  const Eigen::Vector3f& toes = skeleton.offset[roles_of(side).toes];
  return {outline_in_frame(kFootOutline, foot, side, Eigen::Vector3f::Zero()),
          outline_in_frame(kToesOutline, foot, side, toes)};
}

std::vector<Eigen::Vector2f> support_polygon(const Skeleton& skeleton, const JointFrames& frames,
                                             float tolerance_m) {
  std::vector<Eigen::Vector2f> touching;
  const auto collect = [&](const std::vector<Eigen::Vector3f>& points, Role role) {
    for (const Eigen::Vector3f& point : points) {
      const Eigen::Vector3f world = frames.position[role] + frames.orientation[role] * point;
      if (world.z() <= tolerance_m) touching.emplace_back(world.head<2>());
    }
  };
  for (Side side : {Side::left, Side::right}) {
    const SoleOutline sole = sole_outline(skeleton, side);
    collect(sole.foot, roles_of(side).foot);
    collect(sole.toes, roles_of(side).toes);
  }
  return convex_hull(std::move(touching));
}

float signed_distance_inside(const std::vector<Eigen::Vector2f>& polygon,
                             const Eigen::Vector2f& point) {
  float squared_distance = std::numeric_limits<float>::infinity();
  bool inside = polygon.size() > 2;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f& from = polygon[i];
    const Eigen::Vector2f& to = next_corner(polygon, i);
    squared_distance = std::min(squared_distance, squared_distance_to_segment(from, to, point));
    inside = inside && turn(from, to, point) >= 0;
  }
  const float distance = std::sqrt(squared_distance);
  return inside ? distance : -distance;
}

bool is_inside_by(float margin, const std::vector<Eigen::Vector2f>& polygon,
                  const Eigen::Vector2f& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2f& from = polygon[i];
    const Eigen::Vector2f& to = next_corner(polygon, i);
    if (!(turn(from, to, point) >= 0)) return false;
    if (std::sqrt(squared_distance_to_segment(from, to, point)) < margin) return false;
  }
  return polygon.size() > 2;
}

}  // namespace flinch::motion
