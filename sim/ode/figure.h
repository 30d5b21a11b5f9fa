// SPDX-License-Identifier: MIT
#pragma once

#include "sim/collision/pair_clearance.h"
#include "sim/figure/figure_rows.h"
#include "sim/figure/support.h"
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

  void place(const motion::PerBody<BodyState>& figure);
  /// Sets the motors and forces of the next step, of `step_s`, so that it ends at `target`.
  void drive(const ReferenceState& target, double step_s, const Drive& drive);
  /// Adds the ground's support in the next step.
  void add_supports(Contacts& contacts, const ReferenceState& target, double step_s,
                    const Drive& drive) const;
  /// Excludes the figure from the world's steps, or includes it again.
  void set_frozen(bool frozen);

  dBodyID body(motion::Body body) const { return bodies_[body]; }
  motion::PerBody<BodyState> states() const;
  /// Returns the outlines at the bodies' current poses, with their velocities.
  motion::PerBody<MovingShape> shapes() const;

 private:
  /// Motors between a body and the world.
  struct Anchor {
    dJointID linear = nullptr;
    dJointID angular = nullptr;
  };
  static Anchor make_anchor(dWorldID world, dBodyID body);
  /// Without rows the motors are off.
  static void set_anchor(const Anchor& anchor, const std::optional<AnchorRows>& rows);
  void set_joint_motor(motion::Body body, const JointRows& rows, double step_s);
  void set_forces(const ReferenceState& target, double step_s, const Drive& drive);
  const FigureModel& figure_model_;
  motion::PerBody<dBodyID> bodies_;
  motion::PerBody<dJointID> joints_;  // the pelvis has neither
  motion::PerBody<dJointID> motors_;
  Anchor pelvis_;
  motion::PerSide<Anchor> feet_;
};

}  // namespace flinch::sim
