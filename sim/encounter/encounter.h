// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "features/ball_clearance.h"
#include "sim/contact/body_contacts.h"
#include "sim/contact/next_step.h"
#include "sim/contact/step_path.h"
#include "sim/placed_impulse.h"
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
    contact_points_.clear();
    places_.clear();
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
  /// The same without a drive in a lane, beside steps of other encounters: call put_step,
  /// factor_trees(), solve_contacts, move_figures() and end_step, each for all lanes.
  template <std::size_t kLanes>
  void put_step(const ReferenceOnDemand& now, const ReferenceState& target, double step_s,
                TreeLanes<kLanes>& lanes, std::size_t lane) {
    add_contacts(now, target, step_s, {});
    scene_.begin_step(target, step_s, {}, lanes, lane);
  }
  template <std::size_t kLanes>
  void solve_contacts(TreeLanes<kLanes>& lanes, std::size_t lane) {
    scene_.solve_contacts(lanes, lane);
  }
  template <std::size_t kLanes>
  double end_step(const TreeLanes<kLanes>& lanes, std::size_t lane) {
    scene_.end_step(lanes, lane);
    return end_at_contact(lanes.step_s[lane]);
  }
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
  /// Its parts with their places; empty unless SimulationOptions::keeps_places.
  const std::vector<PlacedImpulse>& places() const { return places_; }
  double first_contact_s() const { return first_contact_s_; }  ///< infinity until then
  const Scene& scene() const { return scene_; }

 private:
  bool searches_on_path() const { return options_.contact_search == ContactSearch::on_path; }
  double find_hits(const features::Ball& flight);
  void add_contacts(const ReferenceOnDemand& now, const ReferenceState& target, double step_s,
                    const Drive& drive);
  double end_at_contact(double step_s);
  void add_contact_point(const Eigen::Vector3d& point, motion::Body first, motion::Body second);
  void add_place(motion::Body body, bool from_ball, double impulse_ns,
                 const Eigen::Vector3d& point_in_body, const Eigen::Vector3d& point);

  /// Where a measured contact of the step is, m.
  struct ContactPoint {
    Eigen::Vector3d world;
    Eigen::Vector3d in_first;   ///< in the frame of the centre of mass
    Eigen::Vector3d in_second;  ///< in_first again if there is no second body
  };

  const FigureModel& figure_model_;
  SimulationOptions options_;
  BodyContacts body_contacts_;
  Scene scene_;
  motion::PerBody<MovingShape> shapes_;      // at the start of the step
  std::optional<features::Ball> searching_;  // the ball then, if its contact may end the step
  motion::PerBody<BodyState> before_;        // the figure then, if there is such a ball
  motion::PerBody<double> impulse_;
  std::vector<ContactPoint> contact_points_;  // of the measured contacts, in their order
  std::vector<PlacedImpulse> places_;
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
  contact_points_.clear();
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
    if (!contains(figure_model_.ball_meets, body)) continue;
    if (!may_be_near(flight, shapes_[body], kContactDistance_m)) continue;
    const motion::Clearance near = clearance(flight, shapes_[body]);
    if (!hits(flight, shapes_[body], near)) continue;
    scene_.add_hit(body, near);
    if (options_.keeps_places) add_contact_point(near.point, body, body);
    body_contacts_.add_hit(body);
    is_blow_ = true;
    first_contact_s_ = std::min(first_contact_s_, time_s_);
  }
  is_ball_on_ground_ = ahead.on_ground;
  if (is_ball_on_ground_) scene_.add_bounce();
  if (!searches_on_path()) return ahead.step_s;
  if (is_blow_) return resting_step(flight, shapes_, figure_model_.ball_meets, options_);
  return is_ball_on_ground_ ? ahead.step_s : options_.free_step_s;  // a bounce is on the path too
}

template <class Scene>
bool Encounter<Scene>::may_touch(double horizon_s) const {
  const auto flight = scene_.flight();
  return flight && std::ranges::any_of(motion::kBodies, [&](motion::Body body) {
           return contains(figure_model_.ball_meets, body) &&
                  time_of_contact(*flight, shapes_[body], horizon_s, kNearContactDistance_m,
                                  kMaxAcceleration_mps2)
                      .has_value();
         });
}

template <class Scene>
double Encounter<Scene>::end_step(const ReferenceOnDemand& now, const ReferenceState& target,
                                  double step_s, const Drive& drive) {
  add_contacts(now, target, step_s, drive);
  scene_.step(target, step_s, drive);
  return end_at_contact(step_s);
}

template <class Scene>
void Encounter<Scene>::add_contacts(const ReferenceOnDemand& now, const ReferenceState& target,
                                    double step_s, const Drive& drive) {
  scene_.add_supports(target, step_s, drive);
  for (const BodyContact& contact : body_contacts_.find(shapes_, now)) {
    scene_.add_body_contact(contact.first, contact.second, contact.near, contact.free_closing_mps,
                            contact.is_impact);
    if (options_.keeps_places && contact.is_impact)
      add_contact_point(contact.near.point, contact.first, contact.second);
  }
  searching_.reset();
  if (is_blow_ || !searches_on_path()) return;
  searching_ = scene_.flight();
  if (searching_) before_ = scene_.bodies();
}

/// Ends the step that the scene has taken and returns its length. A ball that touches no body does
/// not change how they move, so its first contact is found on the path that the step has moved them
/// along, and all are placed there.
template <class Scene>
double Encounter<Scene>::end_at_contact(double step_s) {
  double stepped_s = step_s;
  if (searching_) {
    const StepPath path{before_, scene_.bodies(), step_s};
    features::Ball ball = *searching_;
    std::optional<double> bounce_s;
    if (is_ball_on_ground_) {  // which changed its velocity at the step's start
      const features::Ball after = *scene_.flight();
      ball.velocity = (after.position - ball.position) / step_s;
      ball.gravity_mps2 = 0;
    } else {
      bounce_s = time_of_bounce(ball, step_s, kContactDistance_m);
    }
    const auto contact_s = first_contact(figure_model_, path, ball, bounce_s);
    const double until_s = contact_s ? std::max(*contact_s, min_step_s_) : step_s;
    if (until_s < step_s) {
      scene_.place(path.at(until_s), ball.at(until_s));
      stepped_s = until_s;
    }
  }
  std::size_t index = 0;
  for (const ContactImpulse& contact : scene_.impulses(step_s)) {
    const double impulse_ns = body_contacts_.add_impulse(contact, impulse_, stepped_s / step_s);
    if (!options_.keeps_places) continue;
    const ContactPoint& at = contact_points_[index++];
    add_place(contact.first, !contact.second, impulse_ns, at.in_first, at.world);
    if (contact.second) add_place(*contact.second, false, impulse_ns, at.in_second, at.world);
  }
  time_s_ += stepped_s;
  return stepped_s;
}

/// Call before the step moves the bodies.
template <class Scene>
void Encounter<Scene>::add_contact_point(const Eigen::Vector3d& point, motion::Body first,
                                         motion::Body second) {
  const auto seen_from = [&](motion::Body body) {
    const BodyState state = scene_.bodies()[body];
    return Eigen::Vector3d(state.orientation.conjugate() * (point - state.position));
  };
  contact_points_.push_back({point, seen_from(first), seen_from(second)});
}

template <class Scene>
void Encounter<Scene>::add_place(motion::Body body, bool from_ball, double impulse_ns,
                                 const Eigen::Vector3d& point_in_body,
                                 const Eigen::Vector3d& point) {
  if (impulse_ns <= 0) return;
  const Eigen::Vector3f& centre_of_mass = figure_model_.model[body].centre_of_mass;
  places_.push_back(
      {body, from_ball, time_s_, impulse_ns, point_in_body + centre_of_mass.cast<double>(), point});
}

template <class Scene>
void Encounter<Scene>::step_ball_alone() {
  scene_.clear_contacts();
  double step_s = options_.free_step_s;
  if (const auto flight = scene_.flight()) {
    const NextStep ahead = next_step(*flight, {}, options_);
    if (ahead.on_ground) scene_.add_bounce();
    step_s = ahead.step_s;
    scene_.step_ball(step_s);
  }
  time_s_ += step_s;
}

extern template class Encounter<TreeScene>;

}  // namespace flinch::sim
