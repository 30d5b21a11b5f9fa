// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "sim/contact/body_contacts.h"
#include "sim/contact/next_step.h"
#include "sim/contact/step_path.h"
#include "sim/tree/tree_scene.h"

namespace flinch::sim {

/// Runs the steps of a figure and, if there is one, a ball, with the same rules for training and
/// game and for either scene that solves the step: TreeScene or, as the reference, OdeScene.
template <class Scene>
class Encounter {
 public:
  /// Starts at `time_s` in a scene constructed from `arguments`. `figure_model` must outlive this.
  template <class... Arguments>
  Encounter(const FigureModel& figure_model, const SimulationOptions& options, double time_s,
            Arguments&&... arguments)
      : figure_model_(figure_model),
        options_(options),
        body_contacts_(figure_model),
        scene_(std::forward<Arguments>(arguments)...),
        time_s_(time_s) {}

  /// Starts anew at `time_s` as a new object would, without allocating: from the figure's state
  /// `start`, with this ball or, if it is null, none.
  ///
  /// A template, since Clang 14 instantiates a constrained member of a class all the same.
  template <class OfScene = Scene>
  requires std::same_as<OfScene, TreeScene>
  void restart(double time_s, const motion::PerBody<BodyState>& start, const features::Ball* ball) {
    body_contacts_.restart();
    scene_.restart(start, ball);
    impulse_ = {};
    first_contact_s_ = std::numeric_limits<double>::infinity();
    time_s_ = time_s;
    is_blow_ = false;
  }

  /// Finds what the ball hits now and returns the length of step that this allows: at most
  /// `max_step_s`, and at least `min_step_s` even where less is safe. `now` is the state of the
  /// reference motion.
  double begin_step(const ReferenceOnDemand& now, double max_step_s, double min_step_s = 0);
  /// Steps the scene or, with ContactSearch::on_path, the part of the step up to the first contact.
  /// `target` is the state of the reference motion after `step_s`. Returns the length of the step:
  /// `step_s` or, if there is a contact, the time of that.
  double end_step(const ReferenceOnDemand& now, const ReferenceState& target, double step_s,
                  const Drive& drive = {});
  /// A step in which only the ball moves; the figure stays as it is. For a figure that no longer
  /// matters, once the game shows another pose.
  void step_ball_alone();

  /// Whether a body may still strike another body without further help of the ball. Call between
  /// begin_step and end_step.
  bool may_collide_again() const { return body_contacts_.may_collide_again(shapes_); }

  /// Whether the ball may touch the figure within `horizon_s`, however the motors accelerate it.
  /// Call between begin_step and end_step.
  bool may_touch(double horizon_s) const;

  double time_s() const { return time_s_; }
  /// Whether the ball hits the figure in the step that has begun.
  bool is_ball_hit() const { return is_blow_; }
  /// Impulse that each body received from the ball and from bodies that the ball drove into it,
  /// N·s.
  const motion::PerBody<double>& impulse() const { return impulse_; }
  double first_contact_s() const { return first_contact_s_; }  ///< infinity until then
  const Scene& scene() const { return scene_; }

 private:
  bool searches_on_path() const { return options_.contact_search == ContactSearch::on_path; }
  double find_hits(const features::Ball& flight);
  double step_to_contact(const ReferenceState& target, double step_s, const Drive& drive);

  const FigureModel& figure_model_;
  SimulationOptions options_;
  BodyContacts body_contacts_;
  Scene scene_;
  motion::PerBody<MovingShape> shapes_;  // at the start of the step
  motion::PerBody<double> impulse_;
  double first_contact_s_ = std::numeric_limits<double>::infinity();
  double time_s_ = 0;
  double min_step_s_ = 0;
  bool is_blow_ = false;
  bool is_ball_on_ground_ = false;
};

template <class Scene>
double Encounter<Scene>::begin_step(const ReferenceOnDemand& now, double max_step_s,
                                    double min_step_s) {
  const auto flight = scene_.flight();
  double step_s = options_.free_step_s;
  scene_.clear_contacts();
  is_blow_ = false;
  min_step_s_ = std::max(min_step_s, kMinStep_s);
  body_contacts_.begin_step(time_s_);
  if (flight || body_contacts_.is_any_driven()) shapes_ = scene_.shapes();
  const double impact_s = body_contacts_.time_to_impact(shapes_, now, step_s);
  if (impact_s < step_s) {
    step_s = options_.contact_step_s;
    if (searches_on_path()) step_s = std::max(step_s, impact_s);
  }
  if (flight) step_s = std::min(step_s, find_hits(*flight));
  step_s = std::max(step_s, min_step_s);
  // A tiny remainder of a step would cost time and change nothing.
  return step_s > max_step_s * (1 - 1e-9) ? max_step_s : step_s;
}

/// Adds the ball's contacts of now and returns how long a step they allow.
template <class Scene>
double Encounter<Scene>::find_hits(const features::Ball& flight) {
  std::span<const MovingShape> shortening{&*shapes_.begin(), motion::kBodyCount};
  if (searches_on_path()) shortening = {};
  const NextStep ahead = next_step(flight, shortening, options_);
  for (motion::Body body : motion::kBodies) {
    if (!may_be_near(flight, shapes_[body], kContactDistance_m)) continue;
    const motion::Clearance near = clearance(flight.position, flight.radius, shapes_[body]);
    if (!hits(flight, shapes_[body], near)) continue;
    scene_.add_hit(body, near, options_.restitution);
    body_contacts_.add_hit(body);
    is_blow_ = true;
    first_contact_s_ = std::min(first_contact_s_, time_s_);
  }
  is_ball_on_ground_ = ahead.on_ground;
  if (is_ball_on_ground_) scene_.add_bounce(options_.restitution);
  if (!searches_on_path()) return ahead.step_s;
  if (is_blow_) return options_.contact_step_s;
  return is_ball_on_ground_ ? ahead.step_s : options_.free_step_s;  // a bounce is on the path too
}

template <class Scene>
bool Encounter<Scene>::may_touch(double horizon_s) const {
  const auto flight = scene_.flight();
  return flight && std::ranges::any_of(shapes_, [&](const MovingShape& shape) {
           return time_of_contact(*flight, shape, horizon_s, kNearContactDistance_m,
                                  kMaxAcceleration_mps2)
               .has_value();
         });
}

template <class Scene>
double Encounter<Scene>::end_step(const ReferenceOnDemand& now, const ReferenceState& target,
                                  double step_s, const Drive& drive) {
  scene_.add_supports(target, step_s, drive);
  for (const BodyContact& contact : body_contacts_.find(shapes_, now)) {
    scene_.add_body_contact(contact.first, contact.second, contact.near, contact.free_closing_mps,
                            contact.is_impact);
  }
  const double stepped_s = step_to_contact(target, step_s, drive);
  body_contacts_.add_impulses(scene_.impulses(step_s), impulse_, stepped_s / step_s);
  time_s_ += stepped_s;
  return stepped_s;
}

/// A ball that touches no body does not change how they move, so its first contact is found on the
/// path that a step has moved them along, and all are placed there.
template <class Scene>
double Encounter<Scene>::step_to_contact(const ReferenceState& target, double step_s,
                                         const Drive& drive) {
  const auto flight = scene_.flight();
  if (!flight || is_blow_ || !searches_on_path()) {
    scene_.step(target, step_s, drive);
    return step_s;
  }
  const motion::PerBody<BodyState> before = scene_.bodies();
  scene_.step(target, step_s, drive);
  const StepPath path{before, scene_.bodies(), step_s};
  features::Ball ball = *flight;
  std::optional<double> bounce_s;
  if (is_ball_on_ground_) {  // which changed its velocity at the step's start
    const features::Ball after = *scene_.flight();
    ball.velocity = (after.position - ball.position) / step_s;
    ball.gravity_mps2 = 0;
  } else {
    bounce_s = time_of_bounce(ball, step_s, kContactDistance_m);
  }
  const auto contact_s = first_contact(figure_model_, path, ball, bounce_s);
  if (!contact_s) return step_s;
  const double until_s = std::max(*contact_s, min_step_s_);
  if (until_s >= step_s) return step_s;
  scene_.place(path.at(until_s), ball.at(until_s));
  return until_s;
}

template <class Scene>
void Encounter<Scene>::step_ball_alone() {
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

extern template class Encounter<TreeScene>;

}  // namespace flinch::sim
