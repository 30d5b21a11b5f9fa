// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "motion/body.h"
#include "sim/contacts.h"
#include "sim/joint_limits.h"
#include "sim/motors.h"
#include "sim/ode_world.h"
#include "sim/reference.h"
#include "sim/sweep.h"

namespace flinch::sim {

/// What a figure is made of: all that does not change from one simulation to the next.
struct FigurePlan {
  explicit FigurePlan(const motion::Character& character);

  motion::Skeleton skeleton;
  motion::BodyModel model;
  motion::PerBody<MovingShape> outline;      ///< in the frame of the centre of mass, at rest
  motion::PerBody<Eigen::Matrix3d> inertia;  ///< about the centre of mass, kg·m²
  motion::PerBody<Gains> gains;              ///< of the joint to the parent; pelvis: its turning
  Gains pelvis_gains;                        ///< of the pelvis' place
  double mass_kg = 0;                        ///< of the whole figure
  motion::PerBody<JointKind> kinds;
  motion::PerBody<JointLimits> limits;
  /// Pairs that can push each other: neither jointed nor overlapping in the rest pose.
  motion::PerBody<motion::PerBody<bool>> may_touch;
};

/// How hard a figure is driven to its reference: shares of the plan's stiffness (see weakened).
struct Drive {
  double joints = 1;
  double pelvis = 1;
  double most_pelvis_force_n = std::numeric_limits<double>::infinity();
};

/// The 17 bodies in a world, tracking a reference.
class Figure {
 public:
  /// Placed exactly at `start`, with its velocities. `plan` must outlive the figure.
  Figure(const FigurePlan& plan, dWorldID world, const ReferenceState& start);

  /// Sets the motors of the next step, of `step_s`, at whose end `target` is wanted.
  void drive(const ReferenceState& target, double step_s, const Drive& drive = {});
  /// Adds to that step, beforehand, the forces that move the undisturbed figure exactly as its
  /// reference moves, whatever its springs: they then answer to disturbances alone. Takes gravity
  /// off the figure, which those forces would have to bear.
  void carry(const ReferenceState& before, const ReferenceState& after, double step_s);
  /// Lets go of the pelvis for good and gives the figure its weight.
  void let_fall();
  bool is_fallen() const { return fallen_; }
  /// Takes the figure out of the world's steps for good: it stays as it is.
  void freeze();
  /// Adds the ground's support of the feet in that step, but of those that something else holds.
  void stand(Contacts& contacts, const ReferenceState& target, double step_s) const;

  /// Adds the ground's support of whatever part touches it, for a figure that has fallen.
  void lie(Contacts& contacts, double step_s) const;

  void set_held(motion::Body foot, bool held) { held_[foot] = held; }

  dBodyID body(motion::Body body) const { return bodies_[body]; }
  /// The outlines where they are now, as they move now.
  motion::PerBody<MovingShape> shapes() const;

 private:
  void drive_joint(motion::Body body, const ReferenceState& target, double step_s, double share);
  void drive_pelvis(const BodyState& target, double step_s, const Drive& drive);

  const FigurePlan& plan_;
  bool fallen_ = false;
  motion::PerBody<bool> held_;
  motion::PerBody<dBodyID> bodies_;
  motion::PerBody<dJointID> joints_;  // the pelvis has a linear motor in place of a joint
  motion::PerBody<dJointID> motors_;
};

/// How near two parts are: spheres that fill either against the exact other; where each is nearest.
/// The normal points from `second` to `first`.
features::Clearance clearance(const MovingShape& first, const MovingShape& second);

}  // namespace flinch::sim
