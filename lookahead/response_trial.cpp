// SPDX-License-Identifier: MIT
#include "lookahead/response_trial.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "sim/contact/bouncing_ball.h"
#include "sim/figure/figure_rows.h"

namespace flinch::lookahead {
namespace {

using motion::Body;

// The figure lags behind the response by millimetres, and parts may accelerate between two frames:
// a ball this near to the response is simulated, and the simulation decides whether it touches.
constexpr double kNearDistance_m = 0.03;
// As in sim/rehearsal: a ball that stays this clear of the response ends a simulation.
constexpr double kClearDistance_m = 0.05;
// No clip moves a part of the body faster, or the pelvis, or sways in idling; hands reach 8 m/s,
// fast dodges 3 m/s.
constexpr double kMaxPartSpeed_mps = 15;
constexpr double kMaxPelvisSpeed_mps = 6;
constexpr double kMaxSwaySpeed_mps = 0.5;
constexpr double kMaxAhead_s = 0.25;  // that is skipped at once
// By which a time in steps may fall short of a whole number.
constexpr double kRounding = 1e-6;

constexpr std::size_t kNoFrame = static_cast<std::size_t>(-1);

/// The time in which a ball cannot cover `distance_m` to the reach of a figure that idles for
/// `idles_s`.
double time_to_cover(double distance_m, const features::Ball& ball, double idles_s) {
  const double ball_mps = ball.velocity.norm() + ball.gravity_mps2 * kMaxAhead_s;
  const double closing_mps = ball_mps + kMaxSwaySpeed_mps;
  const double while_idle_s = distance_m / closing_mps;
  const double time_s = while_idle_s <= idles_s ? while_idle_s
                                                : idles_s + (distance_m - closing_mps * idles_s) /
                                                                (ball_mps + kMaxPelvisSpeed_mps);
  return std::clamp(time_s, 0.0, kMaxAhead_s);
}

/// What a ball hits on its way to another body. Guards of hand and arm are made for that.
constexpr sim::BodySet kArms = sim::set_of(Body::left_upper_arm) | sim::set_of(Body::left_forearm) |
                               sim::set_of(Body::left_hand) | sim::set_of(Body::right_upper_arm) |
                               sim::set_of(Body::right_forearm) | sim::set_of(Body::right_hand);

int count_of_hit(const motion::PerBody<double>& impulse) {
  return static_cast<int>(std::ranges::count_if(impulse, [](double ns) { return ns > 0; }));
}

}  // namespace

ResponseTrial::ResponseTrial(const sim::FigureModel& figure_model, double reach_m)
    : figure_model_(figure_model),
      reach_m_(reach_m),
      reference_(figure_model),
      lag_(figure_model),
      encounter_(figure_model, options_, 0, figure_model, motion::PerBody<sim::BodyState>{},
                 nullptr, options_.gravity_mps2) {}

/// The body within `distance_m` of which a ball, as it is `since_s` after a frame, comes first
/// before the next frame. Parts move straight from frame to frame.
std::optional<Body> ResponseTrial::first_near(const features::Ball& ball, std::size_t frame,
                                              double since_s, double distance_m) {
  const double rate_hz = reference_.rate_hz();
  double horizon_s = 1 / rate_hz - since_s;
  const motion::PerBody<sim::BodyState>& from = reference_.places_at_frame(frame);
  const motion::PerBody<sim::BodyState>& to = reference_.places_at_frame(frame + 1);
  std::optional<Body> first;
  for (const Body body : motion::kBodies) {
    sim::BodyState part = from[body];
    part.velocity = rate_hz * (to[body].position - part.position);
    part.angular_velocity.setZero();
    // The sphere about its centre contains a part however it turns.
    if (!may_reach(moved_on(part, since_s), figure_model_.radius[body], ball, horizon_s,
                   distance_m)) {
      continue;
    }
    part.angular_velocity =
        rate_hz * motion::rotation_vector(to[body].orientation * part.orientation.conjugate());
    const sim::MovingShape there =
        placed_shape(figure_model_.outline[body], moved_on(part, since_s));
    const auto near_s = time_of_contact(ball, there, horizon_s, distance_m, 0);
    if (!near_s) continue;
    horizon_s = *near_s;
    first = body;
  }
  return first;
}

/// For how many frames a ball, as it is `since_s` after a frame, stays `distance_m` clear of all
/// parts, however they move: 0 if it may come near before the next one.
std::size_t ResponseTrial::clear_frames(const features::Ball& ball, std::size_t frame,
                                        double since_s, double distance_m) {
  const motion::PerBody<sim::BodyState>& places = reference_.places_at_frame(frame);
  double clear_s = kMaxAhead_s;
  for (const Body body : motion::kBodies) {
    const Eigen::Vector3d from_part = ball.position - places[body].position;
    const double gap = from_part.norm() - figure_model_.radius[body] - ball.radius - distance_m -
                       kMaxPartSpeed_mps * since_s;
    const bool leaves = from_part.dot(ball.velocity) >= 0;
    const double speed =
        kMaxPartSpeed_mps + ball.gravity_mps2 * kMaxAhead_s + (leaves ? 0 : ball.velocity.norm());
    clear_s = std::min(clear_s, gap / speed);
  }
  return static_cast<std::size_t>(std::max(clear_s + since_s, 0.0) * reference_.rate_hz());
}

/// What a ball, as it is `since_s` after a frame, does next.
ResponseTrial::Ahead ResponseTrial::look(const features::Ball& ball, std::size_t frame,
                                         double since_s, double distance_m) {
  const double reach_m = (ball.position - reference_.pelvis_at(frame)).norm() - reach_m_ -
                         ball.radius - distance_m - kMaxPelvisSpeed_mps * since_s;
  const double time_s = static_cast<double>(frame) / reference_.rate_hz();
  const double idles_s = std::max(reference_.idles_until_s() - time_s, 0.0);
  const double cover_s = time_to_cover(reach_m, ball, idles_s);
  Ahead ahead{static_cast<std::size_t>(cover_s * reference_.rate_hz()), std::nullopt};
  if (ahead.frames == 0) ahead.frames = clear_frames(ball, frame, since_s, distance_m);
  if (ahead.frames == 0) ahead = {1, first_near(ball, frame, since_s, distance_m)};
  return ahead;
}

/// The first frame after which the ball may come near the figure before the next, also after a
/// bounce.
std::optional<ResponseTrial::Near> ResponseTrial::find_near(const features::Ball& ball,
                                                            double until_s) {
  const double rate_hz = reference_.rate_hz();
  const auto bounce_s = features::time_of_bounce(ball, until_s, sim::kContactDistance_m);
  const std::size_t bounce_frame =
      bounce_s ? static_cast<std::size_t>(*bounce_s * rate_hz) : kNoFrame;
  std::size_t frame = 0;
  for (double time_s = 0; time_s < until_s; time_s = static_cast<double>(frame) / rate_hz) {
    if (frame >= bounce_frame) {
      // A ball that leaves the figure behind when it bounces does not come back.
      const features::Ball there = ball.at(*bounce_s);
      const Eigen::Vector3d from_pelvis = there.position - reference_.pelvis_at(frame);
      const bool leaves = from_pelvis.head<2>().dot(there.velocity.head<2>()) > 0;
      const bool is_far = from_pelvis.norm() - reach_m_ - ball.radius > kNearDistance_m;
      if (is_far && leaves) return std::nullopt;
      return Near{frame, std::nullopt};
    }
    const Ahead ahead = look(ball.at(time_s), frame, 0, kNearDistance_m);
    if (ahead.near) return Near{frame, ahead.near};
    frame = std::min(frame + ahead.frames, std::max(bounce_frame, frame + 1));
  }
  return std::nullopt;
}

/// Whether a ball, as it is at `now_s`, stays clear of the response from `time_s` on.
bool ResponseTrial::stays_clear(const features::Ball& ball, double now_s, double time_s,
                                double until_s) {
  const double rate_hz = reference_.rate_hz();
  sim::BouncingBall bouncing(ball, now_s, options_.restitution);
  auto frame = static_cast<std::size_t>(time_s * rate_hz);
  double since_s = std::max(time_s - static_cast<double>(frame) / rate_hz, 0.0);
  for (; time_s < until_s; time_s = static_cast<double>(frame) / rate_hz, since_s = 0) {
    const Ahead ahead = look(bouncing.at(time_s), frame, since_s, kClearDistance_m);
    if (ahead.near) return false;
    frame += ahead.frames;
  }
  return true;
}

motion::PerBody<sim::BodyState> ResponseTrial::start_at(double time_s,
                                                        const sim::ReferenceState& now) {
  const double step_s = options_.free_step_s;
  // An idling character's lag is small, and it does not matter where a response has just begun.
  if (time_s < 2 * step_s) return now.body;
  return lag_.figure(
      {reference_.places_at(time_s - 2 * step_s), reference_.places_at(time_s - step_s), now,
       reference_.places_at(time_s + step_s)},
      step_s, options_.gravity_mps2);
}

// A hit after the first one depends on a fraction of a millimetre of that, so it is simulated from
// further back: at once if an arm is in the way, and else when there is a second hit.
TrialResult ResponseTrial::meet(const features::Ball& ball, double until_s,
                                const models::ResponseCosts& costs, double max_damage_ns) {
  const auto near = find_near(ball, until_s);
  if (!near) return {};
  const double near_s = static_cast<double>(near->frame) / reference_.rate_hz();
  const double near_step = std::floor(near_s / options_.free_step_s + kRounding);
  const auto begin_s = [&](int settling) {
    return std::max(near_step - settling, 0.0) * options_.free_step_s;
  };
  int steps = 0;
  if (!near->body || !(sim::set_of(*near->body) & kArms)) {
    const TrialResult first =
        run(ball, begin_s(kSettlingSteps), until_s, costs, max_damage_ns, true);
    if (first.is_cut || count_of_hit(first.impulse) < 2) return first;
    steps = first.steps;
  }
  TrialResult result = run(ball, begin_s(kLongSettlingSteps), until_s, costs, max_damage_ns, false);
  result.steps += steps;
  return result;
}

/// Simulates from `begin_s` on, until `until_s` or until nothing can touch any more; or until the
/// damage exceeds `max_damage_ns`; or, if only the `first_hit` is wanted, until a second body is
/// hit.
TrialResult ResponseTrial::run(const features::Ball& ball, double begin_s, double until_s,
                               const models::ResponseCosts& costs, double max_damage_ns,
                               bool first_hit) {
  TrialResult result;
  const features::Ball then = ball.at(begin_s);
  sim::ReferenceState now = reference_.at(begin_s);
  encounter_.restart(begin_s, start_at(begin_s, now), &then);
  while (encounter_.time_s() < until_s) {
    const double time_s = encounter_.time_s();
    const double step_s = encounter_.begin_step(now, until_s - time_s);
    if (step_s >= options_.free_step_s && !encounter_.may_collide_again() &&
        !encounter_.may_touch(step_s) &&
        stays_clear(*encounter_.scene().flight(), time_s, time_s + step_s, until_s)) {
      break;
    }
    const sim::ReferenceState target = reference_.at(time_s + step_s);
    const bool is_whole = encounter_.end_step(now, target, step_s) >= step_s;
    now = is_whole ? target : reference_.at(encounter_.time_s());
    ++result.steps;
    if (std::isinf(encounter_.first_contact_s())) continue;
    if (first_hit && count_of_hit(encounter_.impulse()) > 1) break;
    result.damage_ns = damage_ns(costs, encounter_.impulse());
    if (result.damage_ns > max_damage_ns) {
      result.is_cut = true;
      break;
    }
  }
  result.impulse = encounter_.impulse();
  result.first_contact_s = encounter_.first_contact_s();
  return result;
}

}  // namespace flinch::lookahead
