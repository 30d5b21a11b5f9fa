// SPDX-License-Identifier: MIT
#include "database/import/up_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::kRoles;
using motion::Role;

constexpr int kMostFrames = 400;

// In leg lengths: what is at most this far above the lowest point may be on the ground. A hand that
// sinks into the ground, and feet beside it that float, are no rarity.
constexpr double kContactHeight = 0.5;

// Joints and ends of segments in one frame.
std::vector<Vector3d> points_of(const SourceFigure& figure, const FigureFrame& frame) {
  std::vector<Vector3d> points;
  for (Role role : kRoles) {
    if (!figure.has(role)) continue;
    points.push_back(frame.position[role]);
    if (figure.end[role]) points.push_back(frame.end[role]);
  }
  return points;
}

// A standing man's centre of mass is 0.57 of his height above the ground (de Leva 1996), hips are
// at 0.53 and shoulders at 0.82 of it (Drillis and Contini 1966).
Vector3d centre_of_mass(const FigureFrame& frame) {
  const Vector3d shoulders =
      0.5 * (frame.position[Role::left_upper_arm] + frame.position[Role::right_upper_arm]);
  return hip_centre(frame) + 0.15 * (shoulders - hip_centre(frame));
}

// Returns how unlike a body on the ground a frame with Z up is, in leg lengths: how far the centre
// of mass is outside of its support, plus how far the lowest point is from the height 0.
double unlikeness(const SourceFigure& figure, const FigureFrame& frame) {
  const double leg = leg_length(frame);
  const std::vector<Vector3d> points = points_of(figure, frame);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3d& point : points) lowest = std::min(lowest, point.z());
  std::vector<Eigen::Vector2f> support;
  for (const Vector3d& point : points) {
    if (point.z() < lowest + kContactHeight * leg) support.push_back(point.head<2>().cast<float>());
  }
  const auto inside = static_cast<double>(motion::signed_distance_inside(
      motion::convex_hull(support), centre_of_mass(frame).head<2>().cast<float>()));
  return (std::max(0.0, -inside) + std::abs(lowest)) / leg;
}

template <class Measure>
auto mean_over_frames(const Bvh& bvh, const SourceFigure& figure, const Quaterniond& turn,
                      Measure measure) {
  const int step = std::max(1, bvh.frame_count / kMostFrames);
  auto sum = measure(figure_frame(figure, forward_kinematics(bvh, 0), turn));
  int count = 1;
  for (int frame = step; frame < bvh.frame_count; frame += step, ++count) {
    sum += measure(figure_frame(figure, forward_kinematics(bvh, frame), turn));
  }
  return decltype(sum)(sum / count);
}

double mean_unlikeness(const Bvh& bvh, const SourceFigure& figure, UpAxis up) {
  return mean_over_frames(bvh, figure, to_world(up),
                          [&](const FigureFrame& frame) { return unlikeness(figure, frame); });
}

}  // namespace

UpEstimate estimate_up(const Bvh& bvh, const SourceFigure& figure) {
  const Vector3d mean = mean_over_frames(bvh, figure, Quaterniond::Identity(), feet_to_head);
  const UpAxis of_motion = nearest_axis(mean);
  const std::optional<StandingPose> rest = standing_rest_figure(bvh, figure);
  if (!rest) return {of_motion, mean.dot(direction_of(of_motion)), std::nullopt};
  const UpAxis of_rest = nearest_axis(rest->to_world.conjugate() * Vector3d::UnitZ());
  if (of_rest == of_motion) return {of_motion, 1, std::nullopt};
  const bool is_rest =
      mean_unlikeness(bvh, figure, of_rest) < mean_unlikeness(bvh, figure, of_motion);
  return is_rest ? UpEstimate{of_rest, 1, of_motion} : UpEstimate{of_motion, 1, of_rest};
}

}  // namespace flinch::database
