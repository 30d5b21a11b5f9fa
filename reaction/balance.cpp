// SPDX-License-Identifier: MIT
#include "reaction/balance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/segment.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr double kOnGround_m = 0.05;
constexpr double kStepTime_s = 0.2;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A small set of points on the ground.
class GroundPoints {
 public:
  void add(const Eigen::Vector3d& point) { points_[count_++] = point.head<2>(); }
  std::span<const Eigen::Vector2d> points() const { return {points_.data(), count_}; }

 private:
  std::array<Eigen::Vector2d, 8> points_;
  std::size_t count_ = 0;
};

template <class Visit>
void for_each_sole_corner(const sim::FigureModel& figure_model,
                          const motion::PerBody<sim::BodyState>& bodies, Visit visit) {
  for (Body foot : {Body::left_foot, Body::right_foot}) {
    const sim::MovingShape& sole = figure_model.outline[foot];
    for (int corner = 0; corner < 4; ++corner) {
      visit(bodies[foot].position +
            bodies[foot].orientation *
                sim::sole_point(sole, corner & 1 ? 1 : -1, corner & 2 ? 1 : -1));
    }
  }
}

}  // namespace

// Seen from outside, all points lie on one side of the line to the outermost of them. The nearest
// point of the hull is then on one of its edges, and no segment between other points is nearer.
double distance_outside(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& point) {
  const bool outside = std::any_of(points.begin(), points.end(), [&](const auto& outermost) {
    return std::all_of(points.begin(), points.end(), [&](const auto& other) {
      return cross(outermost - point, other - point) >= 0;
    });
  });
  if (!outside) return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& from : points) {
    for (const auto& to : points) {
      nearest = std::min(nearest, (motion::nearest_on_segment(from, to, point) - point).norm());
    }
  }
  return nearest;
}

double out_of_balance_m(const sim::FigureModel& figure_model,
                        const motion::PerBody<sim::BodyState>& bodies) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for (Body body : motion::kBodies) {
    const double share =
        static_cast<double>(figure_model.model[body].mass_kg) / figure_model.mass_kg;
    centre += share * bodies[body].position;
    velocity += share * bodies[body].velocity;
  }
  const double height = std::max(centre.z(), kOnGround_m);
  const Eigen::Vector3d extrapolated = centre + std::sqrt(height / kGravity_mps2) * velocity;

  GroundPoints all;
  GroundPoints on_ground;
  for_each_sole_corner(figure_model, bodies, [&](const Eigen::Vector3d& corner) {
    all.add(corner);
    if (corner.z() < kOnGround_m) on_ground.add(corner);
  });
  const auto points = on_ground.points().empty() ? all.points() : on_ground.points();
  return distance_outside(points, extrapolated.head<2>());
}

bool is_beyond_a_step(const sim::FigureModel& figure_model, double out_m) {
  const auto length = [&](motion::Role role) {
    return static_cast<double>(figure_model.skeleton.offset[role].norm());
  };
  const double leg = length(motion::Role::left_shin) + length(motion::Role::left_foot);
  return out_m * std::exp(std::sqrt(kGravity_mps2 / leg) * kStepTime_s) > leg;
}

}  // namespace flinch::reaction
