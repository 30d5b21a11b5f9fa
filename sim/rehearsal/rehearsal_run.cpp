// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal_run.h"

#include <algorithm>

#include "sim/contact/bouncing_ball.h"
#include "sim/figure/figure_rows.h"
#include "sim/figure/limit_excess.h"
#include "sim/rehearsal/first_contact.h"

namespace flinch::sim {
namespace {

using motion::Body;

// Tolerance of the exit test: how far a struck figure may be from its undisturbed run, and a
// bounced ball from its predicted path.
constexpr double kClearDistance_m = 0.05;

/// Whether a ball stays clear of the undisturbed figure from `time_s` on.
bool stays_clear(const FigureModel& figure_model, const SimulationOptions& options,
                 const Rehearsal::Track& track, const features::Ball& ball, double now_s,
                 double time_s) {
  BouncingBall bouncing(ball, now_s);
  const auto first =
      std::upper_bound(track.step_begins_s.begin(), track.step_begins_s.end(), time_s);
  auto step = static_cast<std::size_t>(first - track.step_begins_s.begin()) - 1;
  for (; step < track.step_begins_s.size(); ++step) {
    const double from_s = std::max(time_s, track.step_begins_s[step]);
    const double horizon_s = track.step_begins_s[step] + options.free_step_s - from_s;
    const features::Ball then = bouncing.at(from_s);
    if (!track.reach[step].may_reach(then, horizon_s, kClearDistance_m)) continue;
    const StepPath path = track.path_of(step);
    for (Body body : motion::kBodies) {
      if (!contains(figure_model.ball_meets, body)) continue;
      const BodyState state = path.moving(body);
      if (!may_reach(state, figure_model.radius[body], then, options.free_step_s,
                     kClearDistance_m)) {
        continue;
      }
      const MovingShape there =
          placed_shape(figure_model.outline[body], state).at(from_s - track.step_begins_s[step]);
      if (time_of_contact(then, there, horizon_s, kClearDistance_m, 0)) return false;
    }
  }
  return true;
}

}  // namespace

RehearsalRun::RehearsalRun(const FigureModel& figure_model, const SimulationOptions& options)
    : figure_model_(figure_model),
      options_(options),
      encounter_(figure_model, options, 0, figure_model, motion::PerBody<BodyState>{}, nullptr,
                 options.gravity_mps2) {}

bool RehearsalRun::start(const Rehearsal::Track& track, const features::Ball& ball) {
  track_ = &track;
  result_ = {};
  follows_until_s_ = 0;
  result_.is_finite = ball.position.allFinite() && ball.velocity.allFinite();
  if (!result_.is_finite) return false;
  const auto contact = first_contact(figure_model_, track, ball);
  if (!contact) {
    result_.skipped = true;
    return false;
  }
  const features::Ball then = ball.at(contact->time_s);
  if (contact->is_bounce) {
    encounter_.restart(contact->time_s, contact->figure, &then);
    encounter_.step_ball_alone();
    if (leaves(encounter_.time_s())) {
      result_.skipped = true;
      return false;
    }
  }
  encounter_.restart(contact->time_s, contact->figure, &then);
  now_.emplace(track.reference, contact->time_s);
  return begin_step();
}

/// Begins a step, or completes the result if there is none to take.
bool RehearsalRun::begin_step() {
  const double time_s = encounter_.time_s();
  const double left_s = track_->duration_s - time_s;
  if (left_s > 0) {
    const bool is_measured = time_s < follows_until_s_;
    step_s_ = encounter_.begin_step(*now_, is_measured ? std::min(left_s, kFollowStep_s) : left_s);
    if (options_.measures_limits && encounter_.is_ball_hit())
      follows_until_s_ = time_s + kFollowThrough_s;
    const bool is_over = step_s_ >= options_.free_step_s && !encounter_.may_collide_again() &&
                         !encounter_.may_touch(step_s_) && leaves(time_s + step_s_);
    if (!is_over) return true;
  }
  result_.impulse = encounter_.impulse();
  result_.places = encounter_.places();
  result_.first_contact_s = encounter_.first_contact_s();
  result_.solver_messages = encounter_.scene().solver_messages();
  return false;
}

/// A number that is not finite in any body reaches the pelvis in the same step.
bool RehearsalRun::is_finite() const {
  const TreeScene& scene = encounter_.scene();
  return scene.bodies()[Body::pelvis].velocity.allFinite() &&
         scene.ball_state().velocity.allFinite();
}

void RehearsalRun::measure_limits(double stepped_s) {
  if (encounter_.time_s() - stepped_s >= follows_until_s_) return;
  result_.limit_excess_rads +=
      stepped_s * limit_excess_rad(figure_model_, encounter_.scene().bodies(), target_of_step());
}

/// Whether the ball stays clear of the undisturbed figure from `time_s` on.
bool RehearsalRun::leaves(double time_s) const {
  return stays_clear(figure_model_, options_, *track_, *encounter_.scene().flight(),
                     encounter_.time_s(), time_s);
}

}  // namespace flinch::sim
