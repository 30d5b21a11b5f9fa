// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal_run.h"

#include <algorithm>

#include "sim/contact/bouncing_ball.h"
#include "sim/encounter/encounter.h"
#include "sim/figure/figure_rows.h"
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
  BouncingBall bouncing(ball, now_s, options.restitution);
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

SimulationResult run_rehearsed(const FigureModel& figure_model, const SimulationOptions& options,
                               const Rehearsal::Track& track, const features::Ball& ball) {
  SimulationResult result;
  const auto contact = first_contact(figure_model, track, ball);
  if (!contact) {
    result.skipped = true;
    return result;
  }
  const features::Ball then = ball.at(contact->time_s);
  const auto start = [&] {
    return Encounter<TreeScene>(figure_model, options, contact->time_s, figure_model,
                                contact->figure, &then, options.gravity_mps2);
  };
  const auto leaves = [&](const Encounter<TreeScene>& encounter, double time_s) {
    return stays_clear(figure_model, options, track, *encounter.scene().flight(),
                       encounter.time_s(), time_s);
  };
  if (contact->is_bounce) {
    Encounter<TreeScene> bounce = start();
    bounce.step_ball_alone();
    if (leaves(bounce, bounce.time_s())) {
      result.skipped = true;
      return result;
    }
  }
  Encounter<TreeScene> encounter = start();
  ReferenceState now = track.reference.at(contact->time_s);
  while (encounter.time_s() < track.duration_s) {
    const double time_s = encounter.time_s();
    const double step_s = encounter.begin_step(now, track.duration_s - time_s);
    if (step_s >= options.free_step_s && !encounter.may_collide_again() &&
        !encounter.may_touch(step_s) && leaves(encounter, time_s + step_s)) {
      break;
    }
    const ReferenceState target = track.reference.at(time_s + step_s);
    const bool is_whole = encounter.end_step(now, target, step_s) >= step_s;
    now = is_whole ? target : track.reference.at(encounter.time_s());
    ++result.steps;
  }
  result.impulse = encounter.impulse();
  result.first_contact_s = encounter.first_contact_s();
  result.solver_messages = encounter.scene().solver_messages();
  return result;
}

}  // namespace flinch::sim
