// SPDX-License-Identifier: MIT
#pragma once

#include "sim/contact/next_step.h"
#include "sim/ode/contacts.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// A ball in a world. Its gravity is ours: half before a step and half after, so that its free
/// flight is exact, x + v h - g h^2 / 2, whatever the steps.
class BallFlight {
 public:
  BallFlight(dWorldID world, const Ball& ball, double gravity_mps2);

  dBodyID body() const { return body_; }
  features::FreeFlight flight() const;
  void add_ground_contact(Contacts& contacts, double restitution) const;
  /// Steps the ball's world.
  void step(const OdeWorld& world, double step_s) const;

 private:
  void apply_gravity(double time_s) const;

  dBodyID body_;
  double radius_;
  double gravity_mps2_;
};

}  // namespace flinch::sim
