// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "motion/body.h"
#include "sim/ode_world.h"
#include "sim/sweep.h"

namespace flinch::sim {

/// A slower ball does not bounce, m/s.
inline constexpr double kRestSpeed_mps = 0.2;

/// The contact joints of one step.
class Contacts {
 public:
  explicit Contacts(dWorldID world);
  ~Contacts();
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  /// The ball hits a part, at `at` as `approach` gives it: a rigid bounce that gives the relative
  /// velocity along the normal back `restitution` times, with Coulomb friction, and that corrects
  /// no overlap. Charged to `body`.
  void add_hit(dBodyID ball, dBodyID part, motion::Body body, const Approach& at,
               double restitution);
  /// The ball meets the ground: the same law. Charged to nobody.
  void add_bounce(dBodyID ball, const Eigen::Vector3d& point, double restitution);
  /// A part pushes another: no bounce, no friction, no correction of overlap. The normal of `at`
  /// points from `second` to `first`. If `charged`, to both.
  void add_push(dBodyID first_part, motion::Body first, dBodyID second_part, motion::Body second,
                const Approach& at, bool charged);
  /// The ground carries `mass_kg` of a part at `point`, `depth_m` below it, as a critically damped
  /// spring without friction. Charged to nobody.
  void add_support(dBodyID part, const Eigen::Vector3d& point, double depth_m, double mass_kg,
                   double step_s);

  /// What the last step's contacts gave each body: the sum of the magnitudes of their forces,
  /// normal and friction, times the step, N·s.
  motion::PerBody<double> impulses(double step_s) const;

  /// Before the next step's contacts are added.
  void clear();

 private:
  struct Charge {
    dJointFeedback feedback{};
    motion::Body first{};
    std::optional<motion::Body> second;
  };
  dJointID attach(const dContact& contact, dBodyID first, dBodyID second);
  void measure(dJointID joint, motion::Body first, std::optional<motion::Body> second);

  dWorldID world_;
  dJointGroupID group_;
  std::deque<Charge> charges_;  // ODE keeps pointers to the feedback: they must not move
};

}  // namespace flinch::sim
