// SPDX-License-Identifier: MIT
#include "reaction/live_reference.h"

#include <algorithm>

#include "motion/rotation.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr double kCorrectionTime_s = 1.0 / 120;

}  // namespace

LiveReference::LiveReference(const sim::FigureModel& figure_model, const motion::Pose& before,
                             const motion::Pose& now, double dt_s)
    : figure_model_(figure_model),
      last_(sim::state_at_rest(figure_model.skeleton, figure_model.model, before)) {
  move_to(sim::state_at_rest(figure_model.skeleton, figure_model.model, now), dt_s);
}

void LiveReference::add(const motion::Pose& pose, double dt_s, double simulated_until_s) {
  const sim::ReferenceState expected = at(simulated_until_s);
  move_to(sim::state_at_rest(figure_model_.skeleton, figure_model_.model, pose), dt_s);
  time_s_ += dt_s;
  const sim::ReferenceState found = extrapolated(simulated_until_s);
  for (Body body : motion::kBodies) {
    const sim::BodyState& from = expected.body[body];
    const sim::BodyState& to = found.body[body];
    corrections_[body] = {from.position - to.position,
                          motion::rotation_vector(from.orientation * to.orientation.conjugate()),
                          expected.socket[body] - found.socket[body]};
  }
  correction_begin_s_ = simulated_until_s;
}

void LiveReference::move_to(const sim::ReferenceState& next, double dt_s) {
  for (Body body : motion::kBodies) {
    sim::BodyState& state = last_.body[body];
    const sim::BodyState& to = next.body[body];
    state.velocity = (to.position - state.position) / dt_s;
    state.angular_velocity =
        motion::rotation_vector(to.orientation * state.orientation.conjugate()) / dt_s;
    state.position = to.position;
    state.orientation = to.orientation;
    socket_velocity_[body] = (next.socket[body] - last_.socket[body]) / dt_s;
  }
  last_.socket = next.socket;
}

sim::ReferenceState LiveReference::extrapolated(double time_s) const {
  const double ahead_s = time_s - time_s_;
  sim::ReferenceState state = last_;
  for (Body body : motion::kBodies) {
    sim::BodyState& part = state.body[body];
    part.position += ahead_s * part.velocity;
    part.orientation =
        motion::rotation_from_vector<double>(ahead_s * part.angular_velocity) * part.orientation;
    state.socket[body] += ahead_s * socket_velocity_[body];
  }
  return state;
}

sim::ReferenceState LiveReference::at(double time_s) const {
  sim::ReferenceState state = extrapolated(time_s);
  const double over = (time_s - correction_begin_s_) / kCorrectionTime_s;
  if (over > 1 + 1e-9) return state;
  const double share = std::max(1 - over, 0.0);
  for (Body body : motion::kBodies) {
    const Correction& correction = corrections_[body];
    sim::BodyState& part = state.body[body];
    part.position += share * correction.position;
    part.velocity -= correction.position / kCorrectionTime_s;
    part.orientation =
        motion::rotation_from_vector<double>(share * correction.rotation) * part.orientation;
    part.angular_velocity -= correction.rotation / kCorrectionTime_s;
    state.socket[body] += share * correction.socket;
  }
  return state;
}

}  // namespace flinch::reaction
