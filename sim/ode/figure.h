// SPDX-License-Identifier: MIT
#pragma once

#include "sim/collision/pair_clearance.h"
#include "sim/figure/figure_rows.h"
#include "sim/ode/contacts.h"
#include "sim/ode/motors.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// The 17 bodies in a world, tracking a reference.
class Figure {
 public:
  /// Placed exactly at `start`, with its velocities. `figure_model` must outlive the figure.
  Figure(const FigureModel& figure_model, dWorldID world, const ReferenceState& start);

  /// Sets the motors of the next step, of `step_s`, at whose end `target` is wanted.
  void set_motors(const ReferenceState& target, double step_s, const MotorStrength& strength = {});
  /// Adds to that step, beforehand, the forces that move the undisturbed figure exactly as its
  /// reference moves, whatever its springs: they then answer to disturbances alone. Takes gravity
  /// off the figure, which those forces would have to bear.
  void add_feedforward(const ReferenceState& before, const ReferenceState& after, double step_s);
  /// Lets go of the pelvis for good and gives the figure its weight.
  void start_falling();
  bool is_fallen() const { return fallen_; }
  /// Takes the figure out of the world's steps for good: it stays as it is.
  void freeze();
  /// Adds the ground's support of the feet in that step, but of those that something else holds.
  void add_foot_support(Contacts& contacts, const ReferenceState& target, double step_s) const;

  /// Adds the ground's support of whatever part touches it, for a figure that has fallen.
  void add_fallen_support(Contacts& contacts, double step_s) const;

  void set_locked(motion::Body foot, bool locked) { locked_[foot] = locked; }

  dBodyID body(motion::Body body) const { return bodies_[body]; }
  /// The outlines where they are now, as they move now.
  motion::PerBody<MovingShape> shapes() const;

 private:
  void set_joint_motor(motion::Body body, const ReferenceState& target, double step_s,
                       double share);
  void set_pelvis_motor(const BodyState& target, double step_s, const MotorStrength& strength);

  const FigureModel& figure_model_;
  bool fallen_ = false;
  motion::PerBody<bool> locked_;
  motion::PerBody<dBodyID> bodies_;
  motion::PerBody<dJointID> joints_;  // the pelvis has a linear motor in place of a joint
  motion::PerBody<dJointID> motors_;
};

}  // namespace flinch::sim
