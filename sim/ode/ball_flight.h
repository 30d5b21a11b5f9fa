// SPDX-License-Identifier: MIT
#pragma once

#include "sim/contact/next_step.h"
#include "sim/ode/contacts.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// A ball in an ODE world. Applies gravity itself, half before a step and half after it, so that
/// free flight is exact, x + v h - g h^2 / 2, for any step lengths.
class BallFlight {
 public:
  BallFlight(dWorldID world, const features::Ball& ball);

  dBodyID body() const { return body_; }
  features::Ball flight() const;
  /// Moves the ball, which keeps its spin; a rod has that of `ball`.
  void place(const features::Ball& ball);
  /// See bounce_constraint.
  void add_ground_contact(Contacts& contacts, const Eigen::Quaterniond& frame) const;
  /// Steps the ball's world.
  void step(OdeWorld& world, double step_s);

 private:
  void set(const features::Ball& ball);
  void move_rod(const features::Ball& before, double step_s);
  void apply_gravity(double time_s) const;

  dBodyID body_;
  features::Ball thrown_;
};

}  // namespace flinch::sim
