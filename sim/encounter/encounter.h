// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#include "sim/contact/body_contacts.h"
#include "sim/ode/ode_scene.h"
#include "sim/tree/tree_scene.h"

namespace flinch::sim {

/// Runs the steps of a figure and, if there is one, a ball, with the same rules for training and
/// game and for either scene that solves the step, OdeScene or TreeScene.
template <class Scene>
class Encounter {
 public:
  /// Starts at `time_s` in a scene constructed from `arguments`. `figure_model` must outlive this.
  template <class... Arguments>
  Encounter(const FigureModel& figure_model, const SimulationOptions& options, double time_s,
            Arguments&&... arguments)
      : options_(options),
        body_contacts_(figure_model),
        scene_(std::forward<Arguments>(arguments)...),
        time_s_(time_s) {}

  /// Finds what the ball hits now and returns the length of step that this allows: at most
  /// `max_step_s`, and at least `min_step_s` even where less is safe. `now` is the state of the
  /// reference motion.
  double begin_step(const ReferenceState& now, double max_step_s, double min_step_s = 0);
  /// Steps the scene. `target` is the state of the reference motion at the step's end.
  void end_step(const ReferenceState& now, const ReferenceState& target, double step_s);

  /// Whether a body may still strike another body without further help of the ball. Call between
  /// begin_step and end_step.
  bool may_collide_again() const { return body_contacts_.may_collide_again(shapes_); }

  double time_s() const { return time_s_; }
  /// Whether the ball hits the figure in the step that has begun.
  bool is_ball_hit() const { return is_blow_; }
  /// Impulse that each body received from the ball and from bodies that the ball drove into it,
  /// N·s.
  const motion::PerBody<double>& impulse() const { return impulse_; }
  double first_contact_s() const { return first_contact_s_; }  ///< infinity until then
  const Scene& scene() const { return scene_; }

 protected:
  double find_hits(const features::Ball& flight);

  SimulationOptions options_;
  BodyContacts body_contacts_;
  Scene scene_;
  motion::PerBody<MovingShape> shapes_;  // at the start of the step
  motion::PerBody<double> impulse_;
  double first_contact_s_ = std::numeric_limits<double>::infinity();
  double time_s_ = 0;
  bool is_blow_ = false;
};

extern template class Encounter<OdeScene>;
extern template class Encounter<TreeScene>;

/// An encounter in an ODE world. A step is a call of begin_step, of Figure::set_motors and of
/// end_step.
class OdeEncounter : public Encounter<OdeScene> {
 public:
  OdeEncounter(const FigureModel& figure_model, const SimulationOptions& options,
               const ReferenceState& start, const features::Ball* ball)
      : Encounter(figure_model, options, 0, figure_model, start, ball, options.gravity_mps2) {}

  /// A step in which only the ball moves. Freezes the figure permanently.
  void step_ball_alone();

  Figure& figure() { return scene_.figure(); }
  const Figure& figure() const { return scene_.figure(); }
  dWorldID world() const { return scene_.world(); }
  const std::optional<BallFlight>& ball() const { return scene_.ball(); }
};

}  // namespace flinch::sim
