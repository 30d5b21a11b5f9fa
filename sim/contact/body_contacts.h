// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sim/collision/pair_clearance.h"
#include "sim/contact/contact_impulse.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// A contact in which one body pushes another during a step.
struct BodyContact {
  motion::Body first{};
  motion::Body second{};
  motion::Clearance near;  ///< its normal points from `second` to `first`
  double free_closing_mps = 0;
  bool is_impact = false;
};

/// Contacts between bodies of the figure that the ball causes (a hand driven into the face), and
/// the impulses charged for them.
///
/// A body that the ball hits counts as driven for kDrivenTime_s, which is the time that its motors
/// need to absorb the blow. A body that a driven body strikes counts as driven for as long as that
/// body. Where at least one body of a pair is driven and the two touch, they push each other if
/// they close faster than in the reference motion: what the motion itself presses together, such as
/// a knee against the belly, is not caused by the ball.
///
/// Both bodies of a pair are charged for blows only: in the step in which the ball hits one of
/// them, or while they close faster than the reference by kImpactSpeed_mps. A body passes on at
/// most the impulse that it received from the ball or from another body; the motors cause the rest
/// of a push.
class BodyContacts {
 public:
  /// `figure_model` must outlive this.
  explicit BodyContacts(const FigureModel& figure_model);

  /// Forgets all hits, as a new object would.
  void restart();
  /// Call before the other calls of a step. Ends the driven state of bodies whose hit is long past.
  void begin_step(double time_s);
  /// Records that the ball hits `body` in this step.
  void add_hit(motion::Body body);
  /// Whether any body is driven.
  bool is_any_driven() const { return driven() != 0; }
  /// Returns the contacts of this step, valid until the next call. `reference` is the state of the
  /// reference motion now.
  std::span<const BodyContact> find(const motion::PerBody<MovingShape>& shapes,
                                    const ReferenceOnDemand& reference);
  /// Returns the time until the first blow if the bodies keep their velocities, at most
  /// `horizon_s`.
  double time_to_impact(const motion::PerBody<MovingShape>& shapes,
                        const ReferenceOnDemand& reference, double horizon_s) const;
  /// Whether a driven body may still strike another body or come near enough to do so.
  bool may_collide_again(const motion::PerBody<MovingShape>& shapes) const;
  /// Adds the impulse that each body is charged for a contact of a step of which only a `share` was
  /// taken, N·s, and returns it. Call for the contacts of a step in their order.
  double add_impulse(const ContactImpulse& contact, motion::PerBody<double>& impulse,
                     double share = 1);

 private:
  bool driven(motion::Body body) const { return driven_until_s_[body] > time_s_; }
  BodySet driven() const;
  template <class Visit>
  void for_each_pair(const motion::PerBody<MovingShape>& shapes, double distance_m,
                     double horizon_s, Visit visit) const;

  const FigureModel& figure_model_;
  std::vector<BodyContact> found_;
  double time_s_ = 0;
  motion::PerBody<double> driven_until_s_;
  motion::PerBody<double> received_ns_;  ///< received but not yet passed on
  motion::PerBody<bool> hit_now_;
};

}  // namespace flinch::sim
