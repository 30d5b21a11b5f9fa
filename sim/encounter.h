// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "sim/ball_flight.h"
#include "sim/contacts.h"
#include "sim/figure.h"
#include "sim/pushes.h"

namespace flinch::sim {

/// A figure and, if there is one, a ball in a world of their own: what happens in a step, the same
/// for the trainer and for the game. A step is a call of begin_step, of the figure's drive and of
/// end_step.
class Encounter {
 public:
  /// `plan` must outlive this.
  Encounter(const FigurePlan& plan, const SimulationOptions& options, const ReferenceState& start,
            const Ball* ball);

  /// Finds what the ball hits now and how long a step that allows, at most `most_s`; no shorter
  /// than `least_s`, whatever it allows. `now` is where the motion has the figure.
  double begin_step(const ReferenceState& now, double most_s, double least_s = 0);
  /// Steps the world. `target` is where the motion has the figure at the step's end.
  void end_step(const ReferenceState& now, const ReferenceState& target, double step_s);
  /// A step in which only the ball moves: the figure is frozen, for good.
  void step_ball_alone();

  Figure& figure() { return figure_; }
  const Figure& figure() const { return figure_; }
  dWorldID world() const { return world_.id(); }
  const std::optional<BallFlight>& ball() const { return ball_; }
  double time_s() const { return time_s_; }
  /// Whether the ball hits the figure in the step that has begun.
  bool is_blow() const { return is_blow_; }
  /// Impulse that each body took from the ball, and from bodies that the ball drove into it, N·s.
  const motion::PerBody<double>& impulse() const { return impulse_; }
  double first_contact_s() const { return first_contact_s_; }  ///< infinite before

 private:
  double meet();

  SimulationOptions options_;
  Pushes pushes_;
  OdeWorld world_;
  Contacts contacts_;
  Figure figure_;
  std::optional<BallFlight> ball_;
  motion::PerBody<MovingShape> shapes_;  // at the beginning of the step
  motion::PerBody<double> impulse_;
  double first_contact_s_ = std::numeric_limits<double>::infinity();
  double time_s_ = 0;
  bool is_blow_ = false;
};

}  // namespace flinch::sim
