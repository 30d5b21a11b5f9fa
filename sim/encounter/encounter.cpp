// SPDX-License-Identifier: MIT
#include "sim/encounter/encounter.h"

#include <algorithm>

namespace flinch::sim {

using motion::Body;

template <class Scene>
double EncounterIn<Scene>::begin_step(const ReferenceState& now, double most_s, double least_s) {
  const auto flight = scene_.flight();
  double step_s = options_.free_step_s;
  scene_.clear_contacts();
  is_blow_ = false;
  pushes_.begin_step(time_s_);
  if (flight || pushes_.are_possible()) shapes_ = scene_.shapes();
  if (pushes_.ahead(shapes_, now, step_s)) step_s = options_.contact_step_s;
  if (flight) step_s = std::min(step_s, meet(*flight));
  step_s = std::max(step_s, least_s);
  // A last sliver of a step would only cost.
  return step_s > most_s * (1 - 1e-9) ? most_s : step_s;
}

/// Adds what the ball touches now, and says how long a step it allows.
template <class Scene>
double EncounterIn<Scene>::meet(const features::FreeFlight& flight) {
  const StepAhead ahead = step_ahead(flight, {&*shapes_.begin(), motion::kBodyCount}, options_);
  for (Body body : motion::kBodies) {
    if (!may_be_near(flight, shapes_[body], kTouch_m)) continue;
    const motion::Clearance near = clearance(flight.position, flight.radius, shapes_[body]);
    if (!hits(flight, shapes_[body], near)) continue;
    scene_.add_hit(body, near, options_.restitution);
    pushes_.hit(body);
    is_blow_ = true;
    first_contact_s_ = std::min(first_contact_s_, time_s_);
  }
  if (ahead.on_ground) scene_.add_bounce(options_.restitution);
  return ahead.step_s;
}

template <class Scene>
void EncounterIn<Scene>::end_step(const ReferenceState& now, const ReferenceState& target,
                                  double step_s) {
  scene_.add_supports(target, step_s);
  for (const Push& push : pushes_.find(shapes_, now)) {
    scene_.add_push(push.first, push.second, push.near, push.free_closing_mps, push.is_blow);
  }
  scene_.step(target, step_s);
  pushes_.charge(scene_.impulses(step_s), impulse_);
  time_s_ += step_s;
}

template class EncounterIn<OdeScene>;
template class EncounterIn<TreeScene>;

void Encounter::step_ball_alone() {
  scene_.figure().freeze();
  scene_.clear_contacts();
  double step_s = options_.free_step_s;
  if (const auto flight = scene_.flight()) {
    const StepAhead ahead = step_ahead(*flight, {}, options_);
    if (ahead.on_ground) scene_.add_bounce(options_.restitution);
    step_s = ahead.step_s;
    scene_.step_ball(step_s);
  }
  time_s_ += step_s;
}

}  // namespace flinch::sim
