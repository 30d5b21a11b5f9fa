// SPDX-License-Identifier: MIT
#include "lookahead/response_trial.h"

#include <algorithm>
#include <cmath>

#include "lookahead/first_hit.h"
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
// Of the damage until a second body is hit, simulated from kSettlingSteps before, that which
// kLongSettlingSteps confirm in all but one of 200 such hits.
constexpr double kSureShareOfSecondHit = 0.75;
// By which a time in steps may fall short of a whole number.
constexpr double kRounding = 1e-6;

constexpr std::size_t kNoFrame = static_cast<std::size_t>(-1);

/// The time in which a ball cannot cover `distance_m` to the reach of a figure that idles for
/// `idles_s`.
double time_to_cover(double distance_m, const features::Ball& ball, double idles_s) {
  const double ball_mps =
      ball.pivot_velocity().norm() + ball.turning_mps() + ball.gravity_mps2 * kMaxAhead_s;
  const double closing_mps = ball_mps + kMaxSwaySpeed_mps;
  const double while_idle_s = distance_m / closing_mps;
  const double time_s = while_idle_s <= idles_s ? while_idle_s
                                                : idles_s + (distance_m - closing_mps * idles_s) /
                                                                (ball_mps + kMaxPelvisSpeed_mps);
  return std::clamp(time_s, 0.0, kMaxAhead_s);
}

double damage_of(const motion::PerBody<double>& impulse,
                 const motion::PerBody<double>& vulnerability) {
  double damage_ns = 0;
  for (const Body body : motion::kBodies) damage_ns += vulnerability[body] * impulse[body];
  return damage_ns;
}

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

/// Whether a ball, as it is `since_s` after a frame, comes within `distance_m` of one of these
/// bodies before the next frame. Parts move straight from frame to frame.
bool ResponseTrial::comes_near(const features::Ball& ball, std::size_t frame, double since_s,
                               double distance_m, sim::BodySet bodies) {
  const double horizon_s = 1 / reference_.rate_hz() - since_s;
  return std::ranges::any_of(motion::kBodies, [&](Body body) {
    if (!sim::contains(bodies, body)) return false;
    sim::BodyState part = reference_.moving_part(frame, body);
    // The sphere about its centre contains a part however it turns.
    if (!may_reach(moved_on(part, since_s), figure_model_.radius[body], ball, horizon_s,
                   distance_m)) {
      return false;
    }
    part.angular_velocity = reference_.turn_rate(frame, body);
    const sim::MovingShape there =
        placed_shape(figure_model_.outline[body], moved_on(part, since_s));
    return time_of_contact(ball, there, horizon_s, distance_m, 0).has_value();
  });
}

/// For how many frames a ball, as it is `since_s` after a frame, stays clear of all parts, however
/// they move; and if it may come near before the next frame, of which parts.
ResponseTrial::Clear ResponseTrial::clear_of_parts(const features::Ball& ball, std::size_t frame,
                                                   double since_s, double distance_m) {
  const motion::PerBody<sim::BodyState>& places = reference_.places_at_frame(frame);
  const double frame_s = 1 / reference_.rate_hz();
  double clear_s = kMaxAhead_s;
  Clear clear;
  for (const Body body : motion::kBodies) {
    const Eigen::Vector3d from_part = ball.position - places[body].position;
    const double gap = from_part.norm() - figure_model_.radius[body] - ball.bounding_radius() -
                       distance_m - kMaxPartSpeed_mps * since_s;
    const bool leaves = !ball.is_rod() && from_part.dot(ball.velocity) >= 0;
    const double speed = kMaxPartSpeed_mps + ball.gravity_mps2 * kMaxAhead_s +
                         (leaves ? 0 : ball.pivot_velocity().norm() + ball.turning_mps());
    clear_s = std::min(clear_s, gap / speed);
    if (gap / speed + since_s < frame_s) clear.threatened |= sim::set_of(body);
  }
  clear.frames = static_cast<std::size_t>(std::max(clear_s + since_s, 0.0) / frame_s);
  return clear;
}

/// For how many frames a ball, as it is `since_s` after a frame, stays clear of the response: 0 if
/// it comes near before the next one.
std::size_t ResponseTrial::clear_frames(const features::Ball& ball, std::size_t frame,
                                        double since_s, double distance_m) {
  const double reach_m = (ball.position - reference_.pelvis_at(frame)).norm() - reach_m_ -
                         ball.bounding_radius() - distance_m - kMaxPelvisSpeed_mps * since_s;
  const double time_s = static_cast<double>(frame) / reference_.rate_hz();
  const double idles_s = std::max(reference_.idles_until_s() - time_s, 0.0);
  const double cover_s = time_to_cover(reach_m, ball, idles_s);
  const auto frames = static_cast<std::size_t>(cover_s * reference_.rate_hz());
  if (frames > 0) return frames;
  const Clear clear = clear_of_parts(ball, frame, since_s, distance_m);
  if (clear.frames > 0) return clear.frames;
  return comes_near(ball, frame, since_s, distance_m, clear.threatened) ? 0 : 1;
}

/// The first frame after which the ball may come near the figure before the next, also after a
/// bounce.
std::optional<std::size_t> ResponseTrial::find_near(const features::Ball& ball, double until_s) {
  until_s = std::min(until_s, ball.window.until_s);
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
      return frame;
    }
    const std::size_t frames = clear_frames(ball.at(time_s), frame, 0, kNearDistance_m);
    if (frames == 0) return frame;
    frame = std::min(frame + frames, std::max(bounce_frame, frame + 1));
  }
  return std::nullopt;
}

/// Whether a ball, as it is at `now_s`, stays clear of the response from `time_s` on.
bool ResponseTrial::stays_clear(const features::Ball& ball, double now_s, double time_s,
                                double until_s) {
  const double rate_hz = reference_.rate_hz();
  sim::BouncingBall bouncing(ball, now_s);
  auto frame = static_cast<std::size_t>(time_s * rate_hz);
  double since_s = std::max(time_s - static_cast<double>(frame) / rate_hz, 0.0);
  for (; time_s < until_s; time_s = static_cast<double>(frame) / rate_hz, since_s = 0) {
    const std::size_t frames = clear_frames(bouncing.at(time_s), frame, since_s, kClearDistance_m);
    if (frames == 0) return false;
    frame += frames;
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

// A hit after the first one depends on a fraction of a millimetre of that, so where there is one,
// all is simulated again from further back.
TrialResult ResponseTrial::meet(const features::Ball& ball, double until_s,
                                const motion::PerBody<double>& vulnerability,
                                double max_damage_ns) {
  const auto near = find_near(ball, until_s);
  if (!near) return {};
  if (std::isfinite(max_damage_ns) && !ball.is_rod()) {
    const FirstHit hit = least_first_hit(reference_, figure_model_, ball, *near, vulnerability);
    if (hit.damage_ns > max_damage_ns) return {{}, hit.damage_ns, hit.contact_s, 0, true};
  }
  const double near_s = static_cast<double>(*near) / reference_.rate_hz();
  const int near_step = static_cast<int>(near_s / options_.free_step_s + kRounding);
  const Conditions conditions{ball, until_s, vulnerability, max_damage_ns};
  TrialResult first = run(near_step, std::min(kSettlingSteps, near_step), conditions, true);
  if (first.is_cut || count_of_hit(first.impulse) < 2) return first;
  first.damage_ns *= kSureShareOfSecondHit;
  first.is_cut = first.damage_ns > max_damage_ns;
  if (first.is_cut) return first;
  TrialResult result = run(near_step, std::min(kLongSettlingSteps, near_step), conditions, false);
  result.steps += first.steps;
  return result;
}

/// Takes the figure alone to the beginning of a step: it starts `steps` before, or at perception.
void ResponseTrial::settle(int near_step, int steps) {
  const int first = near_step - steps;
  const auto begin_s = [&](int step) { return step * options_.free_step_s; };
  sim::ReferenceState now = reference_.at(begin_s(first));
  encounter_.restart(begin_s(first), start_at(begin_s(first), now), nullptr);
  for (int step = first; step < near_step; ++step) {
    const double step_s = encounter_.begin_step(now, options_.free_step_s);
    const sim::ReferenceState target = reference_.at(begin_s(step + 1));
    encounter_.end_step(now, target, step_s);
    now = target;
  }
}

/// Simulates the ball from the beginning of a step on and the figure from `settling` steps before,
/// until nothing can touch any more or until the damage exceeds the limit; or, if only the
/// `first_hit` is wanted, until a second body is hit.
TrialResult ResponseTrial::run(int near_step, int settling, const Conditions& conditions,
                               bool first_hit) {
  settle(near_step, settling);
  TrialResult result;
  result.steps = settling;
  const double begin_s = near_step * options_.free_step_s;
  const features::Ball then = conditions.ball.at(begin_s);
  encounter_.restart(begin_s, encounter_.scene().bodies(), &then);
  sim::ReferenceState now = reference_.at(begin_s);
  while (encounter_.time_s() < conditions.until_s) {
    const double time_s = encounter_.time_s();
    const double step_s = encounter_.begin_step(now, conditions.until_s - time_s);
    if (step_s >= options_.free_step_s && !encounter_.may_collide_again() &&
        !encounter_.may_touch(step_s) &&
        stays_clear(*encounter_.scene().flight(), time_s, time_s + step_s, conditions.until_s)) {
      break;
    }
    const sim::ReferenceState target = reference_.at(time_s + step_s);
    const bool is_whole = encounter_.end_step(now, target, step_s) >= step_s;
    now = is_whole ? target : reference_.at(encounter_.time_s());
    ++result.steps;
    if (std::isinf(encounter_.first_contact_s())) continue;
    result.damage_ns = damage_of(encounter_.impulse(), conditions.vulnerability);
    if (first_hit && count_of_hit(encounter_.impulse()) > 1) break;
    if (result.damage_ns > conditions.max_damage_ns) {
      result.is_cut = true;
      break;
    }
  }
  result.impulse = encounter_.impulse();
  result.first_contact_s = encounter_.first_contact_s();
  return result;
}

}  // namespace flinch::lookahead
