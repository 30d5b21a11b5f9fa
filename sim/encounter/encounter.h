// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#include "sim/contact/pushes.h"
#include "sim/ode/ode_scene.h"
#include "sim/tree/tree_scene.h"

namespace flinch::sim {

/// A figure and, if there is one, a ball: what happens in a step, the same for the trainer and for
/// the game and whichever scene solves it, OdeScene or TreeScene.
template <class Scene>
class EncounterIn {
 public:
  /// At `time_s`, in a scene made of `arguments`. `plan` must outlive this.
  template <class... Arguments>
  EncounterIn(const FigurePlan& plan, const SimulationOptions& options, double time_s,
              Arguments&&... arguments)
      : options_(options),
        pushes_(plan),
        scene_(std::forward<Arguments>(arguments)...),
        time_s_(time_s) {}

  /// Finds what the ball hits now and how long a step that allows, at most `most_s`; no shorter
  /// than `least_s`, whatever it allows. `now` is where the motion has the figure.
  double begin_step(const ReferenceState& now, double most_s, double least_s = 0);
  /// Steps the scene. `target` is where the motion has the figure at the step's end.
  void end_step(const ReferenceState& now, const ReferenceState& target, double step_s);

  /// Whether, but for the ball, a body may still strike another; between begin_step and end_step.
  bool may_strike() const { return pushes_.may_strike(shapes_); }

  double time_s() const { return time_s_; }
  /// Whether the ball hits the figure in the step that has begun.
  bool is_blow() const { return is_blow_; }
  /// Impulse that each body took from the ball, and from bodies that the ball drove into it, N·s.
  const motion::PerBody<double>& impulse() const { return impulse_; }
  double first_contact_s() const { return first_contact_s_; }  ///< infinite before
  const Scene& scene() const { return scene_; }

 protected:
  double meet(const features::FreeFlight& flight);

  SimulationOptions options_;
  Pushes pushes_;
  Scene scene_;
  motion::PerBody<MovingShape> shapes_;  // at the beginning of the step
  motion::PerBody<double> impulse_;
  double first_contact_s_ = std::numeric_limits<double>::infinity();
  double time_s_ = 0;
  bool is_blow_ = false;
};

extern template class EncounterIn<OdeScene>;
extern template class EncounterIn<TreeScene>;

/// An encounter in a world of ODE. A step is a call of begin_step, of the figure's drive and of
/// end_step.
class Encounter : public EncounterIn<OdeScene> {
 public:
  Encounter(const FigurePlan& plan, const SimulationOptions& options, const ReferenceState& start,
            const Ball* ball)
      : EncounterIn(plan, options, 0, plan, start, ball, options.gravity_mps2) {}

  /// A step in which only the ball moves: the figure is frozen, for good.
  void step_ball_alone();

  Figure& figure() { return scene_.figure(); }
  const Figure& figure() const { return scene_.figure(); }
  dWorldID world() const { return scene_.world(); }
  const std::optional<BallFlight>& ball() const { return scene_.ball(); }
};

}  // namespace flinch::sim
