// SPDX-License-Identifier: MIT
#include "sim/encounter/encounter.h"

#include <algorithm>

namespace flinch::sim {

using motion::Body;

template <class Scene>
double Encounter<Scene>::begin_step(const ReferenceState& now, double max_step_s,
                                    double min_step_s) {
  const auto flight = scene_.flight();
  double step_s = options_.free_step_s;
  scene_.clear_contacts();
  is_blow_ = false;
  body_contacts_.begin_step(time_s_);
  if (flight || body_contacts_.is_any_driven()) shapes_ = scene_.shapes();
  if (body_contacts_.is_impact_ahead(shapes_, now, step_s)) step_s = options_.contact_step_s;
  if (flight) step_s = std::min(step_s, find_hits(*flight));
  step_s = std::max(step_s, min_step_s);
  // A tiny remainder of a step would cost time and change nothing.
  return step_s > max_step_s * (1 - 1e-9) ? max_step_s : step_s;
}

/// Adds the ball's contacts of now and returns how long a step they allow.
template <class Scene>
double Encounter<Scene>::find_hits(const features::Ball& flight) {
  const NextStep ahead = next_step(flight, {&*shapes_.begin(), motion::kBodyCount}, options_);
  for (Body body : motion::kBodies) {
    if (!may_be_near(flight, shapes_[body], kContactDistance_m)) continue;
    const motion::Clearance near = clearance(flight.position, flight.radius, shapes_[body]);
    if (!hits(flight, shapes_[body], near)) continue;
    scene_.add_hit(body, near, options_.restitution);
    body_contacts_.add_hit(body);
    is_blow_ = true;
    first_contact_s_ = std::min(first_contact_s_, time_s_);
  }
  if (ahead.on_ground) scene_.add_bounce(options_.restitution);
  return ahead.step_s;
}

template <class Scene>
void Encounter<Scene>::end_step(const ReferenceState& now, const ReferenceState& target,
                                double step_s) {
  scene_.add_supports(target, step_s);
  for (const BodyContact& contact : body_contacts_.find(shapes_, now)) {
    scene_.add_body_contact(contact.first, contact.second, contact.near, contact.free_closing_mps,
                            contact.is_impact);
  }
  scene_.step(target, step_s);
  body_contacts_.add_impulses(scene_.impulses(step_s), impulse_);
  time_s_ += step_s;
}

template class Encounter<OdeScene>;
template class Encounter<TreeScene>;

void OdeEncounter::step_ball_alone() {
  scene_.figure().freeze();
  scene_.clear_contacts();
  double step_s = options_.free_step_s;
  if (const auto flight = scene_.flight()) {
    const NextStep ahead = next_step(*flight, {}, options_);
    if (ahead.on_ground) scene_.add_bounce(options_.restitution);
    step_s = ahead.step_s;
    scene_.step_ball(step_s);
  }
  time_s_ += step_s;
}

}  // namespace flinch::sim
