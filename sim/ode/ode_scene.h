// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/ode/ball_flight.h"
#include "sim/ode/contacts.h"
#include "sim/ode/figure.h"

namespace flinch::sim {

/// A figure and, if there is one, a ball in their own ODE world.
class OdeScene {
 public:
  /// `figure_model` must outlive this. `gravity_mps2` is the figure's; the ball has its own.
  OdeScene(const FigureModel& figure_model, const ReferenceState& start, const features::Ball* ball,
           double gravity_mps2);

  motion::PerBody<MovingShape> shapes() const { return figure_.shapes(); }
  std::optional<features::Ball> flight() const;

  /// Moves figure and ball. The ball keeps its spin.
  void place(const motion::PerBody<BodyState>& figure, const features::Ball& ball);

  // Contacts of the next step; see Contacts.
  void clear_contacts() { contacts_.clear(); }
  void add_hit(motion::Body body, const motion::Clearance& at);
  void add_bounce();
  void add_body_contact(motion::Body first, motion::Body second, const motion::Clearance& at,
                        double free_closing_mps, bool measured);
  void add_supports(const ReferenceState& target, double step_s, const Drive& drive = {});

  /// Runs a step that ends at `target`.
  void step(const ReferenceState& target, double step_s, const Drive& drive = {});
  /// Runs a step of the ball alone.
  void step_ball(double step_s);
  std::span<const ContactImpulse> impulses(double step_s) { return contacts_.impulses(step_s); }

  motion::PerBody<BodyState> bodies() const { return figure_.states(); }
  /// The ball's state; at the origin if there is none.
  BodyState ball_state() const { return ball_ ? state_of(ball_->body()) : BodyState{}; }

 private:
  OdeWorld world_;
  Contacts contacts_;
  Figure figure_;
  std::optional<BallFlight> ball_;
};

}  // namespace flinch::sim
