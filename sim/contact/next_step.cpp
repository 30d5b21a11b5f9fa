// SPDX-License-Identifier: MIT
#include "sim/contact/next_step.h"

#include <algorithm>

#include "features/ball_clearance.h"
#include "sim/contact/contact_constraint.h"

namespace flinch::sim {
namespace {

// How far a rod turns at most in a step in which it rests, radians: where it touches moves along
// it.
constexpr double kMaxRestingTurn = 0.05;

/// Returns the first time within `horizon_s` at which the ball may touch one of the shapes.
std::optional<double> first_contact(const features::Ball& ball, std::span<const MovingShape> shapes,
                                    double horizon_s, double contact_distance_m,
                                    double slack_mps2) {
  std::optional<double> first;
  for (const MovingShape& shape : shapes) {
    if (may_be_near(ball, shape, kContactDistance_m)) {
      const motion::Clearance near = clearance(ball, shape);
      if (near.gap <= kContactDistance_m && !hits(ball, shape, near)) continue;
    }
    const auto time_s =
        time_of_contact(ball, shape, first.value_or(horizon_s), contact_distance_m, slack_mps2);
    if (time_s) first = time_s;
  }
  return first;
}

bool hits_any(const features::Ball& ball, std::span<const MovingShape> shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const MovingShape& shape) {
    return may_be_near(ball, shape, kContactDistance_m) &&
           hits(ball, shape, clearance(ball, shape));
  });
}

double free_step_among(const features::Ball& ball, std::span<const MovingShape> shapes,
                       const SimulationOptions& options) {
  if (hits_any(ball, shapes)) return options.contact_step_s;
  const auto can_touch = first_contact(ball, shapes, options.free_step_s, kNearContactDistance_m,
                                       kMaxAcceleration_mps2);
  if (!can_touch) return options.free_step_s;
  if (*can_touch >= options.contact_step_s) return *can_touch;
  const auto touch = first_contact(ball, shapes, options.contact_step_s, kContactDistance_m, 0);
  return touch ? std::max(*touch, kMinStep_s) : options.contact_step_s;
}

}  // namespace

NextStep next_step(const features::Ball& ball, std::span<const MovingShape> shapes,
                   const SimulationOptions& options) {
  NextStep ahead;
  ahead.step_s = free_step_among(ball, shapes, options);
  const auto bounce = features::time_of_bounce(ball, ahead.step_s, kContactDistance_m);
  if (!bounce) return ahead;
  if (*bounce <= kMinStep_s) {
    ahead.on_ground = true;
    // The velocity changes sign within the step of a bounce, so that step is short. A ball that
    // lies or rolls needs no short step.
    if (-ball.velocity.z() > kMinBounceSpeed_mps) {
      ahead.step_s = std::min(ahead.step_s, options.contact_step_s);
    }
  } else {
    ahead.step_s = *bounce;
  }
  return ahead;
}

double resting_step(const features::Ball& ball, const motion::PerBody<MovingShape>& shapes,
                    BodySet meets, const SimulationOptions& options) {
  if (ball.bounce.restitution > kMaxRestingBounce) return options.contact_step_s;
  double step_s = options.resting_step_s;
  if (ball.is_rod()) step_s = std::min(step_s, kMaxRestingTurn / ball.rod.angular_velocity.norm());
  step_s = std::max(step_s, options.contact_step_s);
  for (const motion::Body body : motion::kBodies) {
    if (!contains(meets, body)) continue;
    const MovingShape& shape = shapes[body];
    if (may_be_near(ball, shape, kContactDistance_m)) {
      const motion::Clearance near = clearance(ball, shape);
      const double closing =
          -near.normal.dot(ball.velocity_of(near.point) - shape.velocity_at(near.point));
      if (hits(ball, shape, near) && closing > kMinBounceSpeed_mps) return options.contact_step_s;
      if (near.gap <= kContactDistance_m) continue;  // rests there, or separates
    }
    if (const auto touch_s = time_of_contact(ball, shape, step_s, kContactDistance_m, 0))
      step_s = std::max(*touch_s, options.contact_step_s);
  }
  return step_s;
}

bool hits(const features::Ball& ball, const MovingShape& shape, const motion::Clearance& near) {
  return near.gap <= kContactDistance_m && ball.window.is_open() &&
         near.normal.dot(ball.velocity_of(near.point) - shape.velocity_at(near.point)) < 0;
}

}  // namespace flinch::sim
