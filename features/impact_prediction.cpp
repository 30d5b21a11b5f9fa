// SPDX-License-Identifier: MIT
#include "features/impact_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/ball.h"
#include "features/ball_clearance.h"
#include "motion/collision_shape.h"
#include "motion/enum_array.h"

namespace flinch::features {
namespace {

using motion::Body;
using motion::Target;

constexpr double kContactTolerance_m = 1e-3;  // m
/// Within this distance of the figure's bounding sphere, its bodies are tested.
constexpr double kNearDistance_m = 0.05;  // m
/// The struck target is the aimed-at one unless the path passes another nearer by more than this.
constexpr double kStruckTargetMargin_m = 0.05;  // m
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr motion::EnumArray<Outcome, std::string_view, 4> kOutcomeNames{"unusable", "miss",
                                                                        "impact", "touching"};

bool is_within(const Eigen::Vector3f& vector, float max) {
  return vector.allFinite() && vector.cwiseAbs().maxCoeff() <= max;
}

bool is_within(float number, float max) {
  return number >= 0 && number <= max;  // false for NaN
}

bool is_valid_input(const Threat& threat, const CollisionFigure& figure, const MotionBounds& bounds,
                    const PredictionOptions& options) {
  return figure.skeleton && figure.model && is_within(figure.reach_m, kMaxExtent) &&
         is_usable(threat) && is_within(options.horizon_s, kMaxHorizon_s) &&
         is_within(options.gravity_mps2, kMaxExtent) &&
         is_within(bounds.pelvis_centre, kMaxExtent) && is_within(bounds.radius, kMaxExtent) &&
         is_within(bounds.max_speed_mps, kMaxSurfaceSpeed_mps);
}

// The gap to a convex outline is a convex function along a straight line. The ball approaches at c
// = -n·v now, the outline's surface moves at up to u, and gravity bends the path by g s^2 / 2, so
// the gap after a time s is at least
//
// gap - (c + u) s - g s^2 / 2,
//
// which is not negative up to its positive root. (Conservative advancement, Mirtich 1996, with the
// approach speed in place of the total speed.) The points of a rod that turns do not fly straight:
// for one, c is the largest speed that any of them has.
double safe_step(double gap, double closing_mps, double gravity_mps2) {
  const double root = std::sqrt(closing_mps * closing_mps + 2 * gravity_mps2 * gap);
  if (closing_mps > 0) return 2 * gap / (closing_mps + root);
  return gravity_mps2 > 0 ? (root - closing_mps) / gravity_mps2 : kInfinity;
}

/// How far the axis of a ball, which is a point, or of a rod is from a point, m.
double distance_to(const Ball& ball, const Eigen::Vector3d& point) {
  const double along =
      std::clamp(ball.rod.axis.dot(point - ball.position), -ball.rod.to_butt_m, ball.rod.to_tip_m);
  return (ball.position + along * ball.rod.axis - point).norm();
}

// A rod that turns may come near several times: the passage that begins at the touch counts. It is
// looked at in steps, and the nearest of these is refined by golden sections.
double time_rod_nearest(const Ball& rod, const Eigen::Vector3d& centre, double start_s,
                        double horizon_s) {
  constexpr int kSteps = 24;
  constexpr double kStep_s = 0.005;
  constexpr int kSections = 24;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  const auto distance_at = [&](double time_s) { return distance_to(rod.at(time_s), centre); };
  double best_s = start_s;
  double best = distance_at(start_s);
  for (int i = 1; i <= kSteps; ++i) {
    const double time_s = std::min(start_s + i * kStep_s, horizon_s);
    const double distance = distance_at(time_s);
    if (distance >= best) break;
    best = distance;
    best_s = time_s;
  }
  double low_s = std::max(best_s - kStep_s, start_s);
  double high_s = std::min(best_s + kStep_s, horizon_s);
  for (int i = 0; i < kSections; ++i) {
    const double width_s = golden * (high_s - low_s);
    if (distance_at(high_s - width_s) < distance_at(low_s + width_s)) {
      high_s = low_s + width_s;
    } else {
      low_s = high_s - width_s;
    }
  }
  return 0.5 * (low_s + high_s);
}

// The ball is nearest to c where f(t) = (x - c) . v changes from negative, it approaches, to
// positive. That is later where it approaches now, or where it slows down as it departs, because
// f'(t) = v^2 + (x - c) . a is negative; otherwise it is earlier. Newton's method finds it, with
// bisection where a step would leave the interval that holds it: a ball that hardly moves has no
// tangent to follow. Never outside of [0, horizon_s].
double time_nearest(const Ball& ball, const Eigen::Vector3d& centre, double start_s,
                    double horizon_s) {
  if (ball.is_rod()) return time_rod_nearest(ball, centre, start_s, horizon_s);
  constexpr int kMaxIterations = 60;  // as bisection needs; Newton's method needs about five
  constexpr double kResolution_s = 1e-12;
  const Eigen::Vector3d fall(0, 0, -ball.gravity_mps2);
  double before_s = 0;
  double after_s = horizon_s;
  double time_s = start_s;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector3d offset = ball.position_at(time_s) - centre;
    const Eigen::Vector3d velocity = ball.velocity_at(time_s);
    const double value = offset.dot(velocity);
    const double slope = velocity.squaredNorm() + offset.dot(fall);
    (value < 0 || slope < 0 ? before_s : after_s) = time_s;
    double next_s = slope > 0 ? time_s - value / slope : kInfinity;
    if (!(next_s >= before_s && next_s <= after_s)) next_s = 0.5 * (before_s + after_s);
    const bool is_found = std::abs(next_s - time_s) < kResolution_s;
    time_s = next_s;
    if (is_found) break;
  }
  // A ball that slows down need not come back.
  const auto distance_at = [&](double at_s) { return (ball.position_at(at_s) - centre).norm(); };
  return distance_at(time_s) <= distance_at(start_s) ? time_s : start_s;
}

/// Searches for the impact of a ball on a figure.
class ImpactSearch {
 public:
  ImpactSearch(const Ball& ball, const CollisionFigure& figure, const PredictedMotion& ahead,
               double horizon_s)
      : ball_(ball),
        figure_(figure),
        ahead_(ahead),
        horizon_s_(std::min(horizon_s, ball.window.until_s)),
        pelvis_centre_(ahead.bounds().pelvis_centre.cast<double>()) {}

  PredictedImpact until(double end_s) {
    double time_s = std::max(ball_.window.from_s, 0.0);
    end_s = std::min(end_s, horizon_s_);
    while (time_s <= end_s) {
      const double step_s = step_outside(time_s);
      if (step_s > 0) {
        time_s += step_s;
        continue;
      }
      const double step_inside_s = update_nearest_body(time_s);
      if (std::isnan(step_inside_s)) return {};
      if (nearest_.gap <= kContactTolerance_m) return impact_at(time_s);
      time_s += step_inside_s;
    }
    return {.outcome = Outcome::miss};
  }

 private:
  /// Returns how long the ball stays outside the figure's bounding sphere; 0 near it.
  double step_outside(double time_s) const {
    const Eigen::Vector3d offset = ball_.position_at(time_s) - pelvis_centre_;
    const double distance = offset.norm();
    const MotionBounds& bounds = ahead_.bounds();
    const double gap =
        distance - ball_.bounding_radius() - static_cast<double>(bounds.radius + figure_.reach_m);
    if (gap < kNearDistance_m) return 0;
    const double closing_mps = ball_.is_rod() ? max_rod_speed_mps(time_s)
                                              : -offset.dot(ball_.velocity_at(time_s)) / distance;
    return safe_step(gap, closing_mps, ball_.gravity_mps2);
  }

  /// No point of the rod is faster then, but for what gravity adds.
  double max_rod_speed_mps(double time_s) const {
    const Ball rod = ball_.at(time_s);
    return rod.pivot_velocity().norm() + rod.turning_mps();
  }

  /// Finds the nearest body. Returns the time in which no body can be touched; NaN for an invalid
  /// pose.
  double update_nearest_body(double time_s) {
    const MotionBounds& bounds = ahead_.bounds();
    if (!has_frames_ || bounds.max_speed_mps > 0) frames_ = frames_at(time_s);
    has_frames_ = true;
    const Ball then = ball_.at(time_s);
    const bool is_rod = then.is_rod();
    const double rod_mps = is_rod ? max_rod_speed_mps(time_s) : 0;
    const double max_closing_mps =
        static_cast<double>(bounds.max_speed_mps) + (is_rod ? rod_mps : then.velocity.norm());
    nearest_.gap = kInfinity;
    double step_s = kInfinity;
    double sum = 0;
    const auto look_at = [&](Body body) {
      const motion::Clearance near =
          clearance(then, motion::collision_shape_of(*figure_.model, frames_, body));
      sum += near.gap;
      if (near.gap < nearest_.gap || (near.gap == nearest_.gap && body < nearest_body_)) {
        nearest_ = near;
        nearest_body_ = body;
      }
      // Half of kContactTolerance_m may be skipped too. Without that, a ball that passes close by
      // would take a very large number of steps.
      const double closing_mps = static_cast<double>(bounds.max_speed_mps) +
                                 (is_rod ? rod_mps : -near.normal.dot(then.velocity));
      step_s = std::min(step_s, safe_step(std::max(near.gap - 0.5 * kContactTolerance_m, 0.0),
                                          closing_mps, ball_.gravity_mps2));
    };
    // The body that was the nearest is likely to be so again: others are then seen to be farther.
    const Body likely = nearest_body_;
    look_at(likely);
    const double max_gap = kContactTolerance_m + max_way_in(step_s, max_closing_mps);
    for (Body body : motion::kBodies) {
      sum += static_cast<double>(frames_.orientation[role_of(body)].squaredNorm());
      if (body != likely && !is_farther_than(body, then, max_gap)) look_at(body);
    }
    return std::isfinite(sum) ? step_s : std::numeric_limits<double>::quiet_NaN();
  }

  /// Whether the gap to a body is greater than this, whatever its orientation.
  bool is_farther_than(Body body, const Ball& then, double gap) const {
    const Eigen::Vector3d joint = frames_.position[role_of(body)].cast<double>();
    const double distance =
        gap + then.bounding_radius() + static_cast<double>(figure_.body_reach_m[body]);
    return (then.position - joint).squaredNorm() > distance * distance;
  }

  /// By how much a gap closes at most in this time: the inverse of safe_step.
  double max_way_in(double time_s, double closing_mps) const {
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

  /// Sets the target that the threat is aimed at, and the time to impact.
  void aim(PredictedImpact& impact) const {
    const double touch_s = static_cast<double>(impact.touch_s);
    double min_distance = kInfinity;
    double time_s = touch_s;
    for (const Target target : motion::kTargets) {
      const Eigen::Vector3d centre = target_centre(*figure_.model, frames_, target).cast<double>();
      const double nearest_s = time_nearest(ball_, centre, touch_s, horizon_s_);
      double distance = distance_to(ball_.at(nearest_s), centre);
      if (target == impact.struck) distance -= kStruckTargetMargin_m;
      if (!(distance < min_distance)) continue;
      min_distance = distance;
      time_s = nearest_s;
      impact.aimed_at = target;
    }
    // The target's centre at that time.
    if (ahead_.bounds().max_speed_mps > 0) {
      const motion::JointFrames then = frames_at(time_s);
      time_s =
          time_nearest(ball_, target_centre(*figure_.model, then, impact.aimed_at).cast<double>(),
                       time_s, horizon_s_);
    }
    impact.time_to_impact_s = static_cast<float>(std::max(time_s, touch_s));
  }

  Ball ball_;
  const CollisionFigure& figure_;
  const PredictedMotion& ahead_;
  double horizon_s_;
  Eigen::Vector3d pelvis_centre_;
  motion::JointFrames frames_;
  bool has_frames_ = false;
  motion::Clearance nearest_;
  Body nearest_body_{};
};

/// Upper bound on the distance from a body's joint to its surface.
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

/// Upper bound on the distance from the pelvis joint to the surface: all bones in one line.
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
  return kOutcomeNames[outcome];
}

CollisionFigure make_collision_figure(const motion::Skeleton& skeleton,
                                      const motion::BodyModel& model) {
  const motion::PerBody<float> body_reach_m = body_reach_of(model);
  return {&skeleton, &model, reach_of(skeleton, body_reach_m), body_reach_m};
}

PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const PredictedMotion& ahead, const PredictionOptions& options) {
  if (!is_valid_input(threat, figure, ahead.bounds(), options)) return {};
  const Ball ball = ball_of(threat, static_cast<double>(options.gravity_mps2));
  const double horizon_s = static_cast<double>(options.horizon_s);
  return ImpactSearch(ball, figure, ahead, horizon_s)
      .until(time_of_bounce(ball, horizon_s, 0).value_or(horizon_s));
}

PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const motion::Loop& stance, const MotionBounds& bounds,
                               const CharacterState& state,
                               const PredictionOptions& options) noexcept {
  if (stance.motion().poses.empty() || !std::isfinite(state.idle_time_s) ||
      !std::isfinite(state.facing)) {
    return {};
  }
  const auto pose_at = [&](float time_s) { return idle_pose(stance, state, time_s); };
  const MotionBounds ahead = placed(bounds, stance, state, options.horizon_s);
  return predict_impact(threat, figure, PredictedMotion(pose_at, ahead), options);
}

PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const motion::Pose& held,
                               const PredictionOptions& options) noexcept {
  const auto pose_at = [&](float) { return held; };
  const MotionBounds still{.pelvis_centre = held.root_position, .radius = 0, .max_speed_mps = 0};
  return predict_impact(threat, figure, PredictedMotion(pose_at, still), options);
}

}  // namespace flinch::features
