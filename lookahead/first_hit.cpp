// SPDX-License-Identifier: MIT
#include "lookahead/first_hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "features/ball_clearance.h"
#include "sim/contact/next_step.h"
#include "sim/contact/step_path.h"
#include "sim/figure/figure_rows.h"

namespace flinch::lookahead {
namespace {

using Eigen::Vector3d;
using motion::Body;

// A part that the ball passes this close by before the hit, or that is this close to it then, may
// be hit first.
constexpr double kGrazingDistance_m = 0.02;
constexpr std::size_t kMaxFrames = 6;  // in which a ball that came near hits, mostly

/// A part that the ball comes within kGrazingDistance_m of before the next frame.
struct NearPart {
  Body body{};
  sim::BodyState state;    ///< at the frame
  sim::MovingShape shape;  ///< then
  double near_s = 0;       ///< when it is that close, s after the frame
};
struct NearParts {
  std::array<NearPart, motion::kBodyCount> parts;
  std::size_t count = 0;
  std::span<const NearPart> all() const { return std::span(parts).first(count); }
};

NearParts near_parts(ResponseReference& reference, const sim::FigureModel& figure_model,
                     const features::Ball& ball, std::size_t frame) {
  const double frame_s = 1 / reference.rate_hz();
  NearParts near;
  for (const Body body : motion::kBodies) {
    if (!sim::contains(figure_model.ball_meets, body)) continue;
    sim::BodyState state = reference.moving_part(frame, body);
    if (!may_reach(state, figure_model.radius[body], ball, frame_s, kGrazingDistance_m)) continue;
    state.angular_velocity = reference.turn_rate(frame, body);
    const sim::MovingShape shape = placed_shape(figure_model.outline[body], state);
    const auto near_s = time_of_contact(ball, shape, frame_s, kGrazingDistance_m, 0);
    if (near_s) near.parts[near.count++] = {body, state, shape, *near_s};
  }
  return near;
}

// A ball that meets a part at the closing speed c, along the unit normal n at the arm r from the
// part's centre of mass, gives a part that is free to move the impulse
//
//   p = (1 + e) c / (1/m + 1/M + a^T I^-1 a),   a = r x n,
//
// with the ball's mass m and bounce e and the part's mass M and inertia I. Joints only make a part
// harder to move, and friction adds to p: the figure receives no less.
//
// Let v be the ball's velocity relative to the part, at the angle x to n: c = v cos x. Where the
// part is d beside its place, the sine of x is larger by at most d / R, R being the distance of the
// ball's centre from that of the surface's curvature.
double least_impulse_ns(const sim::FigureModel& figure_model, const features::Ball& ball,
                        const NearPart& part, double time_s) {
  const features::Ball then = ball.at(time_s);
  const sim::MovingShape shape = part.shape.at(time_s);
  const motion::Clearance at = clearance(then, shape);
  const Vector3d relative = then.velocity - shape.velocity_at(at.point);
  const double closing = -at.normal.dot(relative);
  const double speed = relative.norm();
  if (!(closing > 0)) return 0;
  const bool is_round = shape.kind == motion::Shape::Kind::capsule;
  const double radius = then.radius + (is_round ? shape.radius : 0);
  const double sine = (relative + closing * at.normal).norm() / speed + kMaxLag_m / radius;
  if (sine >= 1) return 0;
  const sim::BodyState state = moved_on(part.state, time_s);
  const Vector3d arm = state.orientation.conjugate() * (at.point - state.position).cross(at.normal);
  const double mobility = 1 / then.mass_kg +
                          1 / static_cast<double>(figure_model.model[part.body].mass_kg) +
                          arm.dot(figure_model.inertia[part.body].inverse() * arm);
  return (1 + then.bounce.restitution) * speed * std::sqrt(1 - sine * sine) / mobility;
}

/// The first time within a frame at which the ball touches one of the parts and closes on it.
std::optional<double> time_of_hit(const NearParts& near, const features::Ball& ball,
                                  double horizon_s) {
  std::optional<double> first_s;
  for (const NearPart& part : near.all()) {
    const auto touch_s =
        time_of_contact(ball, part.shape, first_s.value_or(horizon_s), sim::kContactDistance_m, 0);
    if (!touch_s) continue;
    const features::Ball then = ball.at(*touch_s);
    const sim::MovingShape shape = part.shape.at(*touch_s);
    if (hits(then, shape, clearance(then, shape))) first_s = touch_s;
  }
  return first_s;
}

}  // namespace

FirstHit least_first_hit(ResponseReference& reference, const sim::FigureModel& figure_model,
                         const features::Ball& ball, std::size_t frame,
                         const motion::PerBody<double>& vulnerability) {
  const double frame_s = 1 / reference.rate_hz();
  for (std::size_t k = frame; k < frame + kMaxFrames; ++k) {
    const double begin_s = static_cast<double>(k) * frame_s;
    const features::Ball now = ball.at(begin_s);
    if (time_of_bounce(now, frame_s, sim::kContactDistance_m)) return {};
    const NearParts near = near_parts(reference, figure_model, now, k);
    const auto hit_s = time_of_hit(near, now, frame_s);
    if (!hit_s) continue;
    FirstHit hit{std::numeric_limits<double>::infinity(), begin_s + *hit_s};
    for (const NearPart& part : near.all()) {
      if (part.near_s > *hit_s) continue;
      const double gap_m = features::gap_at(now, *hit_s, part.shape.at(*hit_s));
      if (gap_m > kGrazingDistance_m) return {};
      hit.damage_ns =
          std::min(hit.damage_ns,
                   vulnerability[part.body] * least_impulse_ns(figure_model, now, part, *hit_s));
    }
    return hit;
  }
  return {};
}

}  // namespace flinch::lookahead
