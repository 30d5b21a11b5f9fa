// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/error.h"
#include "sim/encounter/encounter.h"
#include "sim/figure/figure_rows.h"

namespace flinch::sim {
namespace {

using motion::Body;

// Tolerance of the exit test: how far a struck figure may be from its undisturbed run, and a
// bounced ball from its predicted path.
constexpr double kClearDistance_m = 0.05;

bool may_reach(const Rehearsal::Track::Sphere& reach, const features::Ball& ball, double step_s) {
  const double travel = ball.velocity.norm() * step_s + ball.gravity_mps2 * step_s * step_s / 2;
  const double max_distance = reach.radius + ball.radius + travel;
  return (ball.position - reach.centre).squaredNorm() <= max_distance * max_distance;
}

// The gap falls by at most (|v_ball - v_part| + |w| radius + g T) T, and by a T^2 / 2 more where
// the part accelerates. time_of_contact uses a bound of the rate with a T in full and half as much
// besides. This test must use the same bound, or it would shorten steps that the full simulation
// does not shorten.

/// Whether a ball may come within `distance_m` of a part within `time_s` before or after now. Tests
/// the sphere of `radius` about the part's centre of mass; the part may accelerate by `slack_mps2`.
bool may_be_reached(double radius, const BodyState& part, const features::Ball& ball, double time_s,
                    double distance_m, double slack_mps2) {
  const double speed = (ball.velocity - part.velocity).norm() +
                       part.angular_velocity.norm() * radius +
                       (ball.gravity_mps2 + 1.5 * slack_mps2) * time_s;
  const double max_distance = radius + ball.radius + distance_m + speed * time_s;
  return (ball.position - part.position).squaredNorm() <= max_distance * max_distance;
}

/// Returns what next_step returns for the whole figure, but places only the parts that their
/// bounding spheres do not rule out.
NextStep next_step_of_figure(const FigureModel& figure_model, const SimulationOptions& options,
                             const motion::PerBody<BodyState>& figure, const features::Ball& ball) {
  std::array<MovingShape, motion::kBodyCount> shapes;
  std::size_t count = 0;
  for (Body body : motion::kBodies) {
    if (may_be_reached(figure_model.radius[body], figure[body], ball, options.free_step_s,
                       kNearContactDistance_m, kMaxAcceleration_mps2)) {
      shapes[count++] = placed_shape(figure_model.outline[body], figure[body]);
    }
  }
  return next_step(ball, std::span(shapes).first(count), options);
}

/// Path of a ball from a given time on, bouncing off the ground without spin.
class BouncingFlight {
 public:
  BouncingFlight(const features::Ball& ball, double time_s, double restitution)
      : ball_(ball), time_s_(time_s), restitution_(restitution) {}

  features::Ball at(double time_s) {
    while (const auto bounce =
               features::time_of_bounce(ball_, time_s - time_s_, kContactDistance_m)) {
      advance(*bounce);
      if (-ball_.velocity.z() <= kMinBounceSpeed_mps) {
        ball_.velocity.z() = 0;
        ball_.gravity_mps2 = 0;
      } else {
        ball_.velocity.z() *= -restitution_;
      }
    }
    advance(time_s - time_s_);
    return ball_;
  }

 private:
  void advance(double by_s) {
    ball_ = ball_.at(by_s);
    time_s_ += by_s;
  }

  features::Ball ball_;
  double time_s_;
  double restitution_;
};

/// Whether a ball stays clear of the undisturbed figure from `time_s` on.
bool stays_clear(const FigureModel& figure_model, const SimulationOptions& options,
                 const Rehearsal::Track& track, const features::Ball& ball, double now_s,
                 double time_s) {
  BouncingFlight bouncing(ball, now_s, options.restitution);
  const auto first =
      std::upper_bound(track.step_begins_s.begin(), track.step_begins_s.end(), time_s);
  auto step = static_cast<std::size_t>(first - track.step_begins_s.begin()) - 1;
  for (; step < track.step_begins_s.size(); ++step) {
    const double from_s = std::max(time_s, track.step_begins_s[step]);
    const double horizon_s = track.step_begins_s[step] + options.free_step_s - from_s;
    const features::Ball then = bouncing.at(from_s);
    if (!may_reach(track.reach[step], then, horizon_s)) continue;
    for (Body body : motion::kBodies) {
      const BodyState& state = track.figure_at(step)[body];
      if (!may_be_reached(figure_model.radius[body], state, then, options.free_step_s,
                          kClearDistance_m, 0))
        continue;
      const MovingShape there =
          placed_shape(figure_model.outline[body], state).at(from_s - track.step_begins_s[step]);
      if (time_of_contact(then, there, horizon_s, kClearDistance_m, 0)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<std::size_t> first_possible_contact(const FigureModel& figure_model,
                                                  const SimulationOptions& options,
                                                  const Rehearsal::Track& track,
                                                  const features::Ball& ball) {
  for (std::size_t step = 0; step < track.step_begins_s.size(); ++step) {
    const features::Ball flight = ball.at(track.step_begins_s[step]);
    const bool bounces =
        features::time_of_bounce(flight, options.free_step_s, kContactDistance_m).has_value();
    if (!bounces && !may_reach(track.reach[step], flight, options.free_step_s)) continue;
    if (step < track.first_kept) {
      throw Error("simulation", "the ball reaches the figure before the rehearsal starts, at " +
                                    std::to_string(track.from_s) + " s");
    }
    const NextStep ahead =
        next_step_of_figure(figure_model, options, track.figure_at(step), flight);
    if (bounces || ahead.step_s < options.free_step_s) return step;
  }
  return std::nullopt;
}

SimulationResult run_rehearsed(const FigureModel& figure_model, const SimulationOptions& options,
                               const Rehearsal::Track& track, const features::Ball& ball) {
  SimulationResult result;
  const auto contact_step = first_possible_contact(figure_model, options, track, ball);
  if (!contact_step) {
    result.skipped = true;
    return result;
  }
  const double begin_s = track.step_begins_s[*contact_step];
  const features::Ball then = ball.at(begin_s);
  Encounter<TreeScene> encounter(figure_model, options, begin_s, figure_model,
                                 track.figure_at(*contact_step), &then, options.gravity_mps2);
  ReferenceState now = track.reference.at(begin_s);
  while (encounter.time_s() < track.duration_s) {
    const double time_s = encounter.time_s();
    const double step_s = encounter.begin_step(now, track.duration_s - time_s);
    if (step_s >= options.free_step_s && !encounter.may_collide_again() &&
        stays_clear(figure_model, options, track, *encounter.scene().flight(), time_s,
                    time_s + step_s)) {
      break;
    }
    const ReferenceState target = track.reference.at(time_s + step_s);
    encounter.end_step(now, target, step_s);
    now = target;
    ++result.steps;
  }
  result.impulse = encounter.impulse();
  result.first_contact_s = encounter.first_contact_s();
  result.solver_messages = encounter.scene().solver_messages();
  return result;
}

}  // namespace flinch::sim
