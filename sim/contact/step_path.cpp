// SPDX-License-Identifier: MIT
#include "sim/contact/step_path.h"

#include <algorithm>

#include "features/ball_clearance.h"
#include "sim/contact/next_step.h"
#include "sim/figure/figure_rows.h"

namespace flinch::sim {

BodyState StepPath::moving(motion::Body body) const {
  BodyState state = from[body];
  state.velocity = to[body].velocity;
  state.angular_velocity = to[body].angular_velocity;
  return state;
}

BodyState StepPath::at(motion::Body body, double time_s) const {
  BodyState state = moved_on(moving(body), time_s);
  const double share = time_s / step_s;
  state.velocity = (1 - share) * from[body].velocity + share * to[body].velocity;
  state.angular_velocity =
      (1 - share) * from[body].angular_velocity + share * to[body].angular_velocity;
  return state;
}

motion::PerBody<BodyState> StepPath::at(double time_s) const {
  motion::PerBody<BodyState> figure;
  for (motion::Body body : motion::kBodies) figure[body] = at(body, time_s);
  return figure;
}

// The gap falls by at most (|v_ball - v| + |w| radius + g T) T, and by the turning of a rod.
bool may_reach(const BodyState& part, double radius, const features::Ball& ball, double time_s,
               double distance_m) {
  const double speed = (ball.pivot_velocity() - part.velocity).norm() + ball.turning_mps() +
                       part.angular_velocity.norm() * radius + ball.gravity_mps2 * time_s;
  const double max_distance = radius + ball.bounding_radius() + distance_m + speed * time_s;
  return (ball.position - part.position).squaredNorm() <= max_distance * max_distance;
}

namespace {

// Conservative advancement, as in time_of_contact, with the bound of may_reach.
std::optional<double> time_of_touch(const features::Ball& ball, const MovingShape& outline,
                                    double radius, const StepPath& path, motion::Body body,
                                    double horizon_s) {
  const BodyState moving = path.moving(body);
  const double rate = (ball.pivot_velocity() - moving.velocity).norm() + ball.turning_mps() +
                      ball.gravity_mps2 * horizon_s + moving.angular_velocity.norm() * radius;
  double time_s = std::max(ball.window.from_s, 0.0);
  horizon_s = std::min(horizon_s, ball.window.until_s);
  while (time_s <= horizon_s) {
    const MovingShape there = placed_shape(outline, path.at(body, time_s));
    const double gap = features::gap_at(ball, time_s, there);
    if (gap <= kContactDistance_m) {
      const features::Ball then = ball.at(time_s);
      const bool touches = hits(then, there, clearance(then, there));
      return touches ? std::optional(time_s) : std::nullopt;
    }
    if (rate <= 0) return std::nullopt;
    time_s += (gap - 0.5 * kContactDistance_m) / rate;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> first_contact(const FigureModel& figure_model, const StepPath& path,
                                    const features::Ball& ball, std::optional<double> bounce_s) {
  std::optional<double> first_s = bounce_s;
  for (motion::Body body : motion::kBodies) {
    if (!contains(figure_model.ball_meets, body)) continue;
    const double horizon_s = first_s.value_or(path.step_s);
    const double radius = figure_model.radius[body];
    if (!may_reach(path.moving(body), radius, ball, horizon_s, kContactDistance_m)) continue;
    const auto time_s =
        time_of_touch(ball, figure_model.outline[body], radius, path, body, horizon_s);
    if (time_s) first_s = time_s;
  }
  return first_s;
}

}  // namespace flinch::sim
