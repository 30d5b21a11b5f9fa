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

ResponseReference::Frame& ResponseReference::frame(std::size_t k) {
  Frame& frame = frames_[k % kFrames];
  if (frame.number == k) return frame;
  frame.number = k;
  frame.has_places = frame.has_velocities = false;
  frame.pose = runtime::pose_at(response_, static_cast<float>(k) / rate_hz_);
  return frame;
}

ResponseReference::Frame& ResponseReference::placed(std::size_t k) {
  Frame& placed = frame(k);
  if (placed.has_places) return placed;
  placed.has_places = true;
  placed.state = sim::state_at_rest(figure_model_.skeleton, figure_model_.model, placed.pose);
  return placed;
}

sim::BodyState ResponseReference::moving_part(std::size_t k, Body body) {
  sim::BodyState part = placed(k).state.body[body];
  part.velocity = rate_hz() * (placed(k + 1).state.body[body].position - part.position);
  part.angular_velocity.setZero();
  return part;
}

Eigen::Vector3d ResponseReference::turn_rate(std::size_t k, Body body) {
  const Eigen::Quaterniond& from = placed(k).state.body[body].orientation;
  const Eigen::Quaterniond& to = placed(k + 1).state.body[body].orientation;
  return rate_hz() * motion::rotation_vector(to * from.conjugate());
}

const sim::ReferenceState& ResponseReference::moving_at(std::size_t k) {
  Frame& here = placed(k);
  if (here.has_velocities) return here.state;
  const Frame& before = placed(k > 0 ? k - 1 : 0);
  const Frame& after = placed(k + 1);
  const double rate_hz = double{rate_hz_} / (k > 0 ? 2 : 1);
  for (const Body body : motion::kBodies) {
    const sim::BodyState& from = before.state.body[body];
    const sim::BodyState& to = after.state.body[body];
    here.state.body[body].velocity = rate_hz * (to.position - from.position);
    here.state.body[body].angular_velocity =
        rate_hz * motion::rotation_vector(to.orientation * from.orientation.conjugate());
  }
  here.has_velocities = true;
  return here.state;
}

// Free steps end at frames, to within the rounding of their sum.
std::optional<std::size_t> ResponseReference::frame_at(double time_s) const {
  constexpr double kSameFrame = 1e-6;
  const double nearest = std::round(time_s * double{rate_hz_});
  if (std::abs(time_s * double{rate_hz_} - nearest) > kSameFrame) return std::nullopt;
  return static_cast<std::size_t>(std::max(nearest, 0.0));
}

motion::PerBody<sim::BodyState> ResponseReference::places_at(double time_s) {
  const auto k = frame_at(time_s);
  return k ? placed(*k).state.body : at(time_s).body;
}

sim::ReferenceState ResponseReference::at(double time_s) {
  if (const auto k = frame_at(time_s)) return moving_at(*k);
  const double place = std::max(time_s * double{rate_hz_}, 0.0);
  const auto k = static_cast<std::size_t>(place);
  const double weight = place - std::floor(place);
  const motion::Pose pose =
      motion::blend(frame(k).pose, frame(k + 1).pose, static_cast<float>(weight));
  sim::ReferenceState state = sim::state_at_rest(figure_model_.skeleton, figure_model_.model, pose);
  const motion::PerBody<sim::BodyState>& from = moving_at(k).body;
  const motion::PerBody<sim::BodyState>& to = moving_at(k + 1).body;
  for (const Body body : motion::kBodies) {
    state.body[body].velocity = (1 - weight) * from[body].velocity + weight * to[body].velocity;
    state.body[body].angular_velocity =
        (1 - weight) * from[body].angular_velocity + weight * to[body].angular_velocity;
  }
  return state;
}

}  // namespace flinch::lookahead
