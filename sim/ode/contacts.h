// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_constraint.h"
#include "sim/contact/contact_impulse.h"
#include "sim/ode/ode_world.h"

namespace flinch::sim {

/// The contact joints of one step. Allocates nothing after construction except what ODE allocates.
class Contacts {
 public:
  explicit Contacts(dWorldID world);
  ~Contacts();
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  /// The ball hits a part, at `at` as `clearance` returns it; see impact_constraint. Its impulse is
  /// measured.
  void add_hit(dBodyID ball, dBodyID part, motion::Body body, const motion::Clearance& at,
               const features::Bounce& bounce);
  /// The ball hits the ground; see bounce_constraint. Not measured.
  void add_bounce(dBodyID ball, const Eigen::Quaterniond& frame, const features::Bounce& bounce);
  /// A part pushes another; see body_contact_constraint. The normal of `at` points from `second` to
  /// `first`.
  void add_body_contact(dBodyID first_part, motion::Body first, dBodyID second_part,
                        motion::Body second, const motion::Clearance& at, double free_closing_mps,
                        bool measured);
  /// The ground supports a part; see ground_constraint. Not measured.
  void add_support(dBodyID part, const Eigen::Vector3d& point, double depth_m, double mass_kg,
                   double step_s);

  /// Returns the impulses of the last step's measured contacts, in the order in which they were
  /// added. Valid until the next call.
  std::span<const ContactImpulse> impulses(double step_s);

  /// Removes all contacts. Call before adding those of the next step.
  void clear();

 private:
  struct Measured {
    dJointFeedback feedback{};
    motion::Body first{};
    std::optional<motion::Body> second;
  };
  dJointID attach(const ContactConstraint& constraint, dBodyID first, dBodyID second);
  void measure(dJointID joint, motion::Body first, std::optional<motion::Body> second);

  dWorldID world_;
  dJointGroupID group_;
  std::vector<Measured> measured_;  // never grows: ODE keeps pointers to the feedback
  std::vector<ContactImpulse> impulses_;
};

}  // namespace flinch::sim
