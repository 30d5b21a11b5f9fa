// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sim/collision/pair_clearance.h"
#include "sim/contact/contact_impulse.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// A body that pushes another in a step.
struct BodyContact {
  motion::Body first{};
  motion::Body second{};
  motion::Clearance near;  ///< its normal points from `second` to `first`
  double free_closing_mps = 0;
  bool is_impact = false;
};

/// The parts that the ball drives against others, a hand into the face, and who is charged.
///
/// A body that the ball hits is driven for kDrivenTime_s, until its motors have taken the blow
/// back; a body that a driven one strikes, for as long as that one. Pairs of which one is driven
/// push each other where they touch, against closing faster than the reference motion does: what
/// the motion itself presses together, a knee against the belly, is not the ball's doing.
///
/// Both bodies of a pair are charged for blows: in the step in which the ball hits one of them, or
/// where they close faster than the reference by kImpactSpeed_mps. A body passes on at most what it
/// was given, by the ball or by another: the rest of a push is the motors'.
class BodyContacts {
 public:
  /// `figure_model` must outlive this.
  explicit BodyContacts(const FigureModel& figure_model);

  /// Before each step's other calls: the driving of what was hit long ago ends.
  void begin_step(double time_s);
  /// The ball hits `body` in this step.
  void add_hit(motion::Body body);
  /// Whether any body is driven.
  bool is_any_driven() const { return driven() != 0; }
  /// The pushes of this step; valid until the next call. `reference` is where the motion has the
  /// figure now.
  std::span<const BodyContact> find(const motion::PerBody<MovingShape>& shapes,
                                    const ReferenceState& reference);
  /// Whether a blow may fall within `horizon_s` as the bodies move now.
  bool is_impact_ahead(const motion::PerBody<MovingShape>& shapes, const ReferenceState& reference,
                       double horizon_s) const;
  /// Whether a driven body may still strike another, or be near enough to.
  bool may_collide_again(const motion::PerBody<MovingShape>& shapes) const;
  /// Adds to each body's impulse, N·s, what it is charged for a step's contacts.
  void add_impulses(std::span<const ContactImpulse> contacts, motion::PerBody<double>& impulse);

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
  motion::PerBody<double> received_ns_;  ///< and not yet passed on
  motion::PerBody<bool> hit_now_;
};

}  // namespace flinch::sim
