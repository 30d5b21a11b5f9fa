// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/body.h"
#include "sim/ode_world.h"
#include "sim/sweep.h"

namespace flinch::sim {

/// A slower ball does not bounce, m/s.
inline constexpr double kRestSpeed_mps = 0.2;

/// What a measured contact gave in a step: the magnitude of its force, normal and friction, times
/// the step.
struct ContactImpulse {
  motion::Body first{};
  std::optional<motion::Body> second;  ///< none: the ball hit `first`
  double impulse_ns = 0;
};

/// The contact joints of one step. Allocates nothing once made but what ODE does.
class Contacts {
 public:
  explicit Contacts(dWorldID world);
  ~Contacts();
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  /// The ball hits a part, at `at` as `clearance` gives it: a rigid bounce that gives the relative
  /// velocity along the normal back `restitution` times, with Coulomb friction, and that corrects
  /// no overlap. Measured.
  void add_hit(dBodyID ball, dBodyID part, motion::Body body, const features::Clearance& at,
               double restitution);
  /// The ball meets the ground: the same law. Not measured.
  void add_bounce(dBodyID ball, const Eigen::Vector3d& point, double restitution);
  /// A part pushes another: no bounce, no friction, no correction of overlap. The normal of `at`
  /// points from `second` to `first`; the two may close at `free_closing_mps` unhindered.
  void add_push(dBodyID first_part, motion::Body first, dBodyID second_part, motion::Body second,
                const features::Clearance& at, double free_closing_mps, bool measured);
  /// The ground carries `mass_kg` of a part at `point`, `depth_m` below it, as a critically damped
  /// spring without friction. Not measured.
  void add_support(dBodyID part, const Eigen::Vector3d& point, double depth_m, double mass_kg,
                   double step_s);

  /// What the last step's measured contacts gave, in the order in which they were added. Valid
  /// until the next call.
  std::span<const ContactImpulse> impulses(double step_s);

  /// Before the next step's contacts are added.
  void clear();

 private:
  struct Measured {
    dJointFeedback feedback{};
    motion::Body first{};
    std::optional<motion::Body> second;
  };
  dJointID attach(const dContact& contact, dBodyID first, dBodyID second);
  void measure(dJointID joint, motion::Body first, std::optional<motion::Body> second);

  dWorldID world_;
  dJointGroupID group_;
  std::vector<Measured> measured_;  // ODE keeps pointers to the feedback: it never grows
  std::vector<ContactImpulse> impulses_;
};

}  // namespace flinch::sim
