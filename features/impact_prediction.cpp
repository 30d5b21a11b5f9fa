// SPDX-License-Identifier: MIT
#include "features/impact_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/free_flight.h"
#include "features/outline.h"

namespace flinch::features {
namespace {

using motion::Body;
using motion::Target;

constexpr double kTouch = 1e-3;  // m
/// Nearer than this to the sphere about the figure, its bodies are looked at.
constexpr double kNear = 0.05;  // m
/// A path that comes no nearer than by this to another target is aimed at the one that it strikes.
constexpr double kPreference = 0.05;  // m
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::string_view, 4> kOutcomeNames{"unusable", "miss", "impact", "touching"};

bool is_within(const Eigen::Vector3f& vector, float most) {
  return vector.allFinite() && vector.cwiseAbs().maxCoeff() <= most;
}

bool is_within(float number, float most) {
  return number >= 0 && number <= most;  // false for NaN
}

bool can_use(const Threat& threat, const SweptFigure& figure, const Sway& sway,
             const PredictionOptions& options) {
  return figure.skeleton && figure.model && is_within(figure.reach_m, kMostExtent) &&
         is_within(threat.position, kMostExtent) && is_within(threat.velocity, kMostExtent) &&
         is_within(threat.radius, kMostExtent) && is_within(options.horizon_s, kMostHorizon) &&
         is_within(options.gravity_mps2, kMostExtent) && is_within(sway.middle, kMostExtent) &&
         is_within(sway.radius, kMostExtent) && is_within(sway.most_speed_mps, kMostSwaySpeed);
}

// A gap to a convex outline is convex along a straight line, so while the ball closes at c = -n·v
// now, its surface moves at up to u and gravity bends the path by g s^2 / 2, the gap after s is at
// least
//
//     gap - (c + u) s - g s^2 / 2,
//
// which is not negative up to its positive root. (Conservative advancement, Mirtich 1996, with the
// closing speed in place of the speed.)
double safe_step(double gap, double closing_mps, double gravity_mps2) {
  const double root = std::sqrt(closing_mps * closing_mps + 2 * gravity_mps2 * gap);
  if (closing_mps > 0) return 2 * gap / (closing_mps + root);
  return gravity_mps2 > 0 ? (root - closing_mps) / gravity_mps2 : kInfinity;
}

// Where (x - c) . v = 0, by Newton's method, whose derivative is v^2 + (x - c) . a; bounded from
// below where the fall bends the path towards c.
double time_nearest(const FreeFlight& ball, const Eigen::Vector3d& centre, double time_s) {
  constexpr int kIterations = 4;
  const Eigen::Vector3d fall(0, 0, -ball.gravity_mps2);
  for (int i = 0; i < kIterations; ++i) {
    const Eigen::Vector3d offset = ball.position_at(time_s) - centre;
    const Eigen::Vector3d velocity = ball.velocity_at(time_s);
    const double square = velocity.squaredNorm();
    if (!(square > 0)) return time_s;
    time_s -= offset.dot(velocity) / std::max(square + offset.dot(fall), 0.5 * square);
  }
  return time_s;
}

/// A ball on its way to a figure.
class Sweep {
 public:
  Sweep(const FreeFlight& ball, const SweptFigure& figure, const PosesAhead& ahead)
      : ball_(ball), figure_(figure), ahead_(ahead), middle_(ahead.sway().middle.cast<double>()) {}

  PredictedImpact until(double horizon_s) {
    double time_s = 0;
    while (time_s <= horizon_s) {
      const double step_s = step_outside(time_s);
      if (step_s > 0) {
        time_s += step_s;
        continue;
      }
      const double step_inside_s = look_at_bodies(time_s);
      if (std::isnan(step_inside_s)) return {};
      if (nearest_.gap <= kTouch) return impact_at(time_s);
      time_s += step_inside_s;
    }
    return {.outcome = Outcome::miss};
  }

 private:
  /// How long the ball stays outside of the sphere about the figure; 0 near it.
  double step_outside(double time_s) const {
    const Eigen::Vector3d offset = ball_.position_at(time_s) - middle_;
    const double distance = offset.norm();
    const Sway& sway = ahead_.sway();
    const double gap = distance - ball_.radius - static_cast<double>(sway.radius + figure_.reach_m);
    if (gap < kNear) return 0;
    const double closing_mps = -offset.dot(ball_.velocity_at(time_s)) / distance;
    return safe_step(gap, closing_mps, ball_.gravity_mps2);
  }

  /// Finds the nearest body. Returns how long none can be touched; NaN for a pose that is none.
  double look_at_bodies(double time_s) {
    const Sway& sway = ahead_.sway();
    if (!has_frames_ || sway.most_speed_mps > 0) frames_ = frames_at(time_s);
    has_frames_ = true;
    const Eigen::Vector3d centre = ball_.position_at(time_s);
    const Eigen::Vector3d velocity = ball_.velocity_at(time_s);
    const double most_closing_mps = static_cast<double>(sway.most_speed_mps) + velocity.norm();
    nearest_.gap = kInfinity;
    double step_s = kInfinity;
    double sum = 0;
    const auto look_at = [&](Body body) {
      const double least_gap = least_gap_of(body, centre);
      sum += static_cast<double>(frames_.orientation[role_of(body)].squaredNorm());
      if (least_gap > kTouch + way_in(step_s, most_closing_mps)) return;
      const Clearance near =
          clearance(centre, ball_.radius, outline_of(*figure_.model, frames_, body));
      sum += near.gap;
      if (near.gap < nearest_.gap || (near.gap == nearest_.gap && body < nearest_body_)) {
        nearest_ = near;
        nearest_body_ = body;
      }
      // Half of kTouch may be skipped too: it keeps a ball that glides past from taking for ever.
      const double closing_mps =
          static_cast<double>(sway.most_speed_mps) - near.normal.dot(velocity);
      step_s = std::min(step_s, safe_step(std::max(near.gap - 0.5 * kTouch, 0.0), closing_mps,
                                          ball_.gravity_mps2));
    };
    // What was the nearest is likely to be, and others are then seen to be far.
    const Body likely = nearest_body_;
    look_at(likely);
    for (Body body : motion::kBodies) {
      if (body != likely) look_at(body);
    }
    return std::isfinite(sum) ? step_s : std::numeric_limits<double>::quiet_NaN();
  }

  /// The gap to a body is no less, wherever it points.
  double least_gap_of(Body body, const Eigen::Vector3d& centre) const {
    const Eigen::Vector3d joint = frames_.position[role_of(body)].cast<double>();
    return (centre - joint).norm() - ball_.radius - static_cast<double>(figure_.body_reach_m[body]);
  }

  /// The most by which a gap closes in this time: the inverse of safe_step.
  double way_in(double time_s, double closing_mps) const {
    return (closing_mps + 0.5 * ball_.gravity_mps2 * time_s) * time_s;
  }

  motion::JointFrames frames_at(double time_s) const {
    return forward_kinematics(*figure_.skeleton, ahead_.at(static_cast<float>(time_s)));
  }

  PredictedImpact impact_at(double time_s) const {
    PredictedImpact impact;
    impact.outcome = time_s > 0 ? Outcome::impact : Outcome::touching;
    impact.touch_s = static_cast<float>(time_s);
    impact.body = nearest_body_;
    impact.struck = target_of(nearest_body_);
    impact.point = nearest_.point.cast<float>();
    impact.normal = nearest_.normal.cast<float>();
    aim(impact);
    return impact;
  }

  /// Which target the threat is aimed at, and when it would be there.
  void aim(PredictedImpact& impact) const {
    const double touch_s = static_cast<double>(impact.touch_s);
    double least = kInfinity;
    double time_s = touch_s;
    for (int i = 0; i < motion::kTargetCount; ++i) {
      const auto target = static_cast<Target>(i);
      const Eigen::Vector3d centre = target_centre(*figure_.model, frames_, target).cast<double>();
      const double nearest_s = time_nearest(ball_, centre, touch_s);
      double distance = (ball_.position_at(nearest_s) - centre).norm();
      if (target == impact.struck) distance -= kPreference;
      if (!(distance < least)) continue;
      least = distance;
      time_s = nearest_s;
      impact.aimed_at = target;
    }
    // The centre where it will be then.
    if (ahead_.sway().most_speed_mps > 0) {
      const motion::JointFrames then = frames_at(time_s);
      time_s = time_nearest(
          ball_, target_centre(*figure_.model, then, impact.aimed_at).cast<double>(), time_s);
    }
    impact.time_to_impact_s = static_cast<float>(std::max(time_s, touch_s));
  }

  FreeFlight ball_;
  const SweptFigure& figure_;
  const PosesAhead& ahead_;
  Eigen::Vector3d middle_;
  motion::JointFrames frames_;
  bool has_frames_ = false;
  Clearance nearest_;
  Body nearest_body_{};
};

/// The farthest that a body's surface can be from its joint.
motion::PerBody<float> body_reach_of(const motion::BodyModel& model) {
  motion::PerBody<float> reach_m;
  for (Body body : motion::kBodies) {
    const motion::Shape& shape = model[body].shape;
    const bool capsule = shape.kind == motion::Shape::Kind::capsule;
    const float extent = capsule ? shape.half_length + shape.radius : shape.half_extents.norm();
    reach_m[body] = shape.centre.norm() + extent;
  }
  return reach_m;
}

/// The farthest that the surface can be from the pelvis' joint: all bones in one line.
float reach_of(const motion::Skeleton& skeleton, const motion::PerBody<float>& body_reach_m) {
  motion::PerRole<float> from_pelvis;
  for (motion::Role role : motion::kRoles) {
    const auto parent = parent_of(role);
    from_pelvis[role] = parent ? from_pelvis[*parent] + skeleton.offset[role].norm() : 0;
  }
  float reach_m = 0;
  for (Body body : motion::kBodies) {
    reach_m = std::max(reach_m, from_pelvis[role_of(body)] + body_reach_m[body]);
  }
  return reach_m;
}

}  // namespace

std::string_view name_of(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}

SweptFigure make_swept_figure(const motion::Skeleton& skeleton, const motion::BodyModel& model) {
  const motion::PerBody<float> body_reach_m = body_reach_of(model);
  return {&skeleton, &model, reach_of(skeleton, body_reach_m), body_reach_m};
}

PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const PosesAhead& ahead, const PredictionOptions& options) {
  if (!can_use(threat, figure, ahead.sway(), options)) return {};
  const FreeFlight ball{threat.position.cast<double>(), threat.velocity.cast<double>(),
                        static_cast<double>(threat.radius),
                        static_cast<double>(options.gravity_mps2)};
  const double horizon_s = static_cast<double>(options.horizon_s);
  return Sweep(ball, figure, ahead).until(time_of_bounce(ball, horizon_s, 0).value_or(horizon_s));
}

PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const motion::Motion& idle, const Sway& sway,
                               const CharacterState& state,
                               const PredictionOptions& options) noexcept {
  if (idle.poses.empty() || !std::isfinite(state.idle_time_s) || !std::isfinite(state.facing)) {
    return {};
  }
  const auto pose_at = [&](float time_s) { return idle_pose(idle, state, time_s); };
  return predict_impact(threat, figure, PosesAhead(pose_at, placed(sway, state)), options);
}

PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const motion::Pose& held,
                               const PredictionOptions& options) noexcept {
  const auto pose_at = [&](float) { return held; };
  const Sway still{.middle = held.root_position, .radius = 0, .most_speed_mps = 0};
  return predict_impact(threat, figure, PosesAhead(pose_at, still), options);
}

}  // namespace flinch::features
