// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/contacts.h"
#include "sim/ode_world.h"
#include "sim/simulator.h"
#include "sim/sweep.h"

namespace flinch::sim {

/// Surfaces no farther apart touch, m.
inline constexpr double kTouch_m = 1e-4;

/// A ball in a world. Its gravity is ours: half before a step and half after, so that its free
/// flight is exact, x + v h - g h^2 / 2, whatever the steps.
class BallFlight {
 public:
  BallFlight(dWorldID world, const Ball& ball, double gravity_mps2);

  dBodyID body() const { return body_; }
  features::FreeFlight flight() const;
  void meet_ground(Contacts& contacts, double restitution) const;
  /// Steps the ball's world.
  void step(const OdeWorld& world, double step_s) const;

 private:
  void fall(double time_s) const;

  dBodyID body_;
  double radius_;
  double gravity_mps2_;
};

/// What a ball's path says about the next step.
struct StepAhead {
  double step_s = 0;       ///< the longest that is safe
  bool on_ground = false;  ///< the ball touches the ground, falling
};

/// The longest step for a ball among shapes: `free_step_s` while it can touch nothing, up to the
/// time at which it can; `contact_step_s` while it can; the very time of impact where that comes
/// first. Shapes that already part from it do not count.
StepAhead step_ahead(const features::FreeFlight& ball, std::span<const MovingShape> shapes,
                     const SimulationOptions& options);

/// Whether a ball at `near` of a shape touches it and does not part from it.
bool hits(const features::FreeFlight& ball, const MovingShape& shape,
          const features::Clearance& near);

}  // namespace flinch::sim
