// SPDX-License-Identifier: MIT
#include "lookahead/response_reference.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation.h"
#include "motion/rotation.h"

namespace flinch::lookahead {

using motion::Body;

void ResponseReference::follow(const runtime::Response& response, float rate_hz) {
  response_ = response;
  rate_hz_ = rate_hz;
  for (Frame& frame : frames_) frame.number = kNone;
}

const ResponseReference::Frame& ResponseReference::frame(std::size_t k) {
  Frame& frame = frames_[k % kFrames];
  if (frame.number == k) return frame;
  frame.number = k;
  frame.pose = runtime::pose_at(response_, static_cast<float>(k) / rate_hz_);
  frame.at_rest = sim::state_at_rest(figure_model_.skeleton, figure_model_.model, frame.pose);
  return frame;
}

Eigen::Vector3d ResponseReference::pelvis_at(double time_s) {
  return frame(static_cast<std::size_t>(time_s * double{rate_hz_}))
      .pose.root_position.cast<double>();
}

motion::PerBody<sim::BodyState> ResponseReference::bodies_at(std::size_t k) {
  const Frame& before = frame(k > 0 ? k - 1 : 0);
  const Frame& after = frame(k + 1);
  const double rate_hz = double{rate_hz_} / (k > 0 ? 2 : 1);
  motion::PerBody<sim::BodyState> bodies = frame(k).at_rest.body;
  for (const Body body : motion::kBodies) {
    const sim::BodyState& from = before.at_rest.body[body];
    const sim::BodyState& to = after.at_rest.body[body];
    bodies[body].velocity = rate_hz * (to.position - from.position);
    bodies[body].angular_velocity =
        rate_hz * motion::rotation_vector(to.orientation * from.orientation.conjugate());
  }
  return bodies;
}

sim::ReferenceState ResponseReference::at(double time_s) {
  const double place = std::max(time_s * double{rate_hz_}, 0.0);
  const auto k = static_cast<std::size_t>(place);
  const double weight = place - std::floor(place);
  // Free steps end at frames, to within the rounding of their sum.
  constexpr double kSameFrame = 1e-6;
  if (weight < kSameFrame || weight > 1 - kSameFrame) {
    const std::size_t nearest = k + (weight > 0.5 ? 1 : 0);
    sim::ReferenceState state = frame(nearest).at_rest;
    state.body = bodies_at(nearest);
    return state;
  }
  const motion::Pose pose =
      motion::blend(frame(k).pose, frame(k + 1).pose, static_cast<float>(weight));
  sim::ReferenceState state = sim::state_at_rest(figure_model_.skeleton, figure_model_.model, pose);
  const motion::PerBody<sim::BodyState> from = bodies_at(k);
  const motion::PerBody<sim::BodyState> to = bodies_at(k + 1);
  for (const Body body : motion::kBodies) {
    state.body[body].velocity = (1 - weight) * from[body].velocity + weight * to[body].velocity;
    state.body[body].angular_velocity =
        (1 - weight) * from[body].angular_velocity + weight * to[body].angular_velocity;
  }
  return state;
}

}  // namespace flinch::lookahead
