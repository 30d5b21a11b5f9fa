// SPDX-License-Identifier: MIT
#include "lookahead/response_trial.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "sim/contact/bouncing_ball.h"
#include "sim/figure/figure_rows.h"

namespace flinch::lookahead {
namespace {

using motion::Body;

// The figure lags behind the response by millimetres, so a ball this near to the response is
// simulated: the simulation decides whether it touches.
constexpr double kNearDistance_m = 0.03;
// How much the parts of a response may accelerate in a free step, beside what kNearDistance_m
// covers.
constexpr double kNearAcceleration_mps2 = 100;
// As in sim/rehearsal: a ball that stays this clear of the response ends a simulation.
constexpr double kClearDistance_m = 0.05;
// No clip moves the pelvis faster; the fastest dodges reach 3 m/s.
constexpr double kMaxPelvisSpeed_mps = 6;

/// Whether the ball comes within `distance_m` of a part within `horizon_s`, if the part keeps its
/// velocity to within `slack_mps2`.
bool comes_near(const sim::FigureModel& figure_model, Body body, const sim::BodyState& state,
                const features::Ball& ball, double horizon_s, double distance_m,
                double slack_mps2) {
  const double radius = figure_model.radius[body];
  const double speed = (ball.velocity - state.velocity).norm() +
                       state.angular_velocity.norm() * radius +
                       (ball.gravity_mps2 + 1.5 * slack_mps2) * horizon_s;
  const double reach = radius + ball.radius + distance_m + speed * horizon_s;
  if ((ball.position - state.position).squaredNorm() > reach * reach) return false;
  return time_of_contact(ball, placed_shape(figure_model.outline[body], state), horizon_s,
                         distance_m, slack_mps2)
      .has_value();
}

/// The number of steps in which a ball cannot cover `distance_m` to a figure, at least 1.
std::size_t steps_to_cover(double distance_m, const features::Ball& ball, double step_s) {
  constexpr double kMaxAhead_s = 0.25;
  const double speed = ball.velocity.norm() + ball.gravity_mps2 * kMaxAhead_s + kMaxPelvisSpeed_mps;
  const double ahead_s = std::min(distance_m / speed, kMaxAhead_s);
  return static_cast<std::size_t>(std::max(ahead_s / step_s, 1.0));
}

}  // namespace

ResponseTrial::ResponseTrial(const sim::FigureModel& figure_model, double reach_m)
    : figure_model_(figure_model),
      reach_m_(reach_m),
      reference_(figure_model),
      encounter_(figure_model, options_, 0, figure_model, motion::PerBody<sim::BodyState>{},
                 nullptr, options_.gravity_mps2) {}

/// Distance of the ball's surface from the sphere about the pelvis that no part of the figure
/// leaves.
double ResponseTrial::distance_to_reach_m(const features::Ball& ball, double time_s) {
  const Eigen::Vector3d pelvis = reference_.pelvis_at(time_s);
  return (ball.position - pelvis).norm() - reach_m_ - ball.radius;
}

/// The first free step in which the ball may come near the figure, also after a bounce.
std::optional<std::size_t> ResponseTrial::first_near_step(const features::Ball& ball,
                                                          double until_s) {
  const double step_s = options_.free_step_s;
  const double bounce_s =
      features::time_of_bounce(ball, until_s, sim::kContactDistance_m).value_or(until_s);
  std::size_t step = 0;
  for (double time_s = 0; time_s < until_s; time_s = static_cast<double>(step) * step_s) {
    const features::Ball there = ball.at(std::min(time_s, bounce_s));
    const double distance_m = distance_to_reach_m(there, time_s) - kNearDistance_m;
    if (time_s + step_s > bounce_s && bounce_s < until_s) {
      // A ball that leaves the figure behind when it bounces does not come back.
      const Eigen::Vector3d from_pelvis = there.position - reference_.pelvis_at(time_s);
      const bool leaves = from_pelvis.head<2>().dot(there.velocity.head<2>()) > 0;
      if (distance_m > 0 && leaves) return std::nullopt;
      return step;
    }
    if (distance_m > 0) {
      std::size_t ahead = steps_to_cover(distance_m, there, step_s);
      const auto bounce_step = static_cast<std::size_t>(bounce_s / step_s);
      if (step < bounce_step) ahead = std::min(ahead, bounce_step - step);
      step += std::max<std::size_t>(ahead, 1);
      continue;
    }
    const sim::ReferenceState now = reference_.at(time_s);
    for (const Body body : motion::kBodies) {
      if (comes_near(figure_model_, body, now.body[body], there, step_s, kNearDistance_m,
                     kNearAcceleration_mps2)) {
        return step;
      }
    }
    ++step;
  }
  return std::nullopt;
}

/// Whether a ball, as it is at `now_s`, stays clear of the response from `time_s` on.
bool ResponseTrial::stays_clear(const features::Ball& ball, double now_s, double time_s,
                                double until_s) {
  const double step_s = options_.free_step_s;
  sim::BouncingBall bouncing(ball, now_s, options_.restitution);
  while (time_s < until_s) {
    const features::Ball& there = bouncing.at(time_s);
    const double distance_m = distance_to_reach_m(there, time_s) - kClearDistance_m;
    if (distance_m > 0) {
      time_s += step_s * static_cast<double>(steps_to_cover(distance_m, there, step_s));
      continue;
    }
    const sim::ReferenceState then = reference_.at(time_s);
    for (const Body body : motion::kBodies) {
      if (comes_near(figure_model_, body, then.body[body], there, step_s, kClearDistance_m, 0))
        return false;
    }
    time_s += step_s;
  }
  return true;
}

// Implicit springs of 60 rad/s that follow a reference in steps of 1/60 s leave no lag of position
// at a constant acceleration, and a velocity that leads from the step before to this one.
motion::PerBody<sim::BodyState> ResponseTrial::start_at(double time_s,
                                                        const sim::ReferenceState& now) {
  const double step_s = options_.free_step_s;
  motion::PerBody<sim::BodyState> start = now.body;
  if (time_s < step_s) return start;
  const sim::ReferenceState before = reference_.at(time_s - step_s);
  for (const Body body : motion::kBodies) {
    const sim::BodyState& from = before.body[body];
    sim::BodyState& to = start[body];
    to.velocity = (to.position - from.position) / step_s;
    to.angular_velocity =
        motion::rotation_vector(to.orientation * from.orientation.conjugate()) / step_s;
  }
  return start;
}

TrialResult ResponseTrial::meet(const features::Ball& ball, double until_s,
                                const models::ResponseCosts& costs, double max_damage_ns) {
  TrialResult result;
  const auto near_step = first_near_step(ball, until_s);
  if (!near_step) return result;
  const std::size_t first_step = *near_step - std::min(*near_step, kSettlingSteps);
  const double begin_s = static_cast<double>(first_step) * options_.free_step_s;
  const features::Ball then = ball.at(begin_s);
  sim::ReferenceState now = reference_.at(begin_s);
  encounter_.restart(begin_s, start_at(begin_s, now), &then);
  while (encounter_.time_s() < until_s) {
    const double time_s = encounter_.time_s();
    const double step_s = encounter_.begin_step(now, until_s - time_s);
    if (step_s >= options_.free_step_s && !encounter_.may_collide_again() &&
        !encounter_.may_touch(step_s) &&
        stays_clear(*encounter_.scene().flight(), time_s, time_s + step_s, until_s)) {
      break;
    }
    const sim::ReferenceState target = reference_.at(time_s + step_s);
    const bool is_whole = encounter_.end_step(now, target, step_s) >= step_s;
    now = is_whole ? target : reference_.at(encounter_.time_s());
    ++result.steps;
    if (std::isinf(encounter_.first_contact_s())) continue;
    result.damage_ns = damage_ns(costs, encounter_.impulse());
    if (result.damage_ns > max_damage_ns) {
      result.is_cut = true;
      break;
    }
  }
  result.impulse = encounter_.impulse();
  result.first_contact_s = encounter_.first_contact_s();
  return result;
}

}  // namespace flinch::lookahead
