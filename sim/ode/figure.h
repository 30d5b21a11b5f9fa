// SPDX-License-Identifier: MIT
#pragma once

#include "sim/collision/pair_clearance.h"
#include "sim/figure/figure_rows.h"
#include "sim/ode/contacts.h"
#include "sim/ode/motors.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// The 17 bodies of a figure in an ODE world, tracking a reference.
class Figure {
 public:
  /// Places the figure exactly at `start`, with its velocities. `figure_model` must outlive the
  /// figure.
  Figure(const FigureModel& figure_model, dWorldID world, const ReferenceState& start);

  /// Sets the motors for the next step, of `step_s`, so that it ends at `target`.
  void set_motors(const ReferenceState& target, double step_s, const MotorStrength& strength = {});
  /// Adds feed-forward forces to the next step that move the undisturbed figure exactly as its
  /// reference moves, for any spring gains; the springs then answer disturbances only. Disables
  /// gravity for the figure, since these forces would otherwise have to balance it.
  void add_feedforward(const ReferenceState& before, const ReferenceState& after, double step_s);
  /// Permanently releases the pelvis from its motors and lets gravity act on the figure.
  void start_falling();
  bool is_fallen() const { return fallen_; }
  /// Permanently excludes the figure from the world's steps; it stays as it is.
  void freeze();
  /// Adds the ground's support of the feet for the next step, except of feet that something else
  /// holds.
  void add_foot_support(Contacts& contacts, const ReferenceState& target, double step_s) const;

  /// Adds the ground's support of every part that touches it, for a figure that has fallen.
  void add_fallen_support(Contacts& contacts, double step_s) const;

  void set_locked(motion::Body foot, bool locked) { locked_[foot] = locked; }

  dBodyID body(motion::Body body) const { return bodies_[body]; }
  /// Returns the outlines at the bodies' current poses, with their velocities.
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
