// SPDX-License-Identifier: MIT
#include "sim/encounter.h"

#include <algorithm>

namespace flinch::sim {

using motion::Body;

Encounter::Encounter(const FigurePlan& plan, const SimulationOptions& options,
                     const ReferenceState& start, const Ball* ball)
    : options_(options), pushes_(plan), contacts_(world_.id()), figure_(plan, world_.id(), start) {
  dWorldSetGravity(world_.id(), 0, 0, -options.gravity_mps2);
  if (ball) ball_.emplace(world_.id(), *ball, options.gravity_mps2);
}

double Encounter::begin_step(const ReferenceState& now, double most_s, double least_s) {
  shapes_ = figure_.shapes();
  double step_s = options_.free_step_s;
  contacts_.clear();
  is_blow_ = false;
  pushes_.begin_step(time_s_);
  if (pushes_.ahead(shapes_, now, step_s)) step_s = options_.contact_step_s;
  if (ball_) step_s = std::min(step_s, meet());
  step_s = std::max(step_s, least_s);
  // A last sliver of a step would only cost.
  return step_s > most_s * (1 - 1e-9) ? most_s : step_s;
}

/// Adds what the ball touches now, and says how long a step it allows.
double Encounter::meet() {
  const features::FreeFlight flight = ball_->flight();
  const StepAhead ahead = step_ahead(flight, {&*shapes_.begin(), motion::kBodyCount}, options_);
  for (Body body : motion::kBodies) {
    const features::Clearance near = clearance(flight.position, flight.radius, shapes_[body]);
    if (!hits(flight, shapes_[body], near)) continue;
    contacts_.add_hit(ball_->body(), figure_.body(body), body, near, options_.restitution);
    pushes_.hit(body);
    is_blow_ = true;
    first_contact_s_ = std::min(first_contact_s_, time_s_);
  }
  if (ahead.on_ground) ball_->meet_ground(contacts_, options_.restitution);
  return ahead.step_s;
}

void Encounter::end_step(const ReferenceState& now, const ReferenceState& target, double step_s) {
  if (figure_.is_fallen()) {
    figure_.lie(contacts_, step_s);
  } else {
    figure_.stand(contacts_, target, step_s);
  }
  pushes_.add(figure_, shapes_, now, contacts_);
  if (ball_) {
    ball_->step(world_, step_s);
  } else {
    world_.step(step_s);
  }
  pushes_.charge(contacts_.impulses(step_s), impulse_);
  time_s_ += step_s;
}

void Encounter::step_ball_alone() {
  figure_.freeze();
  contacts_.clear();
  double step_s = options_.free_step_s;
  if (ball_) {
    const StepAhead ahead = step_ahead(ball_->flight(), {}, options_);
    if (ahead.on_ground) ball_->meet_ground(contacts_, options_.restitution);
    step_s = ahead.step_s;
    ball_->step(world_, step_s);
  }
  time_s_ += step_s;
}

}  // namespace flinch::sim
