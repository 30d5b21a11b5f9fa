// SPDX-License-Identifier: MIT
#pragma once

#include "sim/contacts.h"
#include "sim/figure.h"

namespace flinch::sim {

/// The parts that the ball drives against others, a hand into the face.
///
/// A body that the ball hits is driven for kDriveTime_s, until its motors have taken the blow back;
/// a body that a driven one strikes, for as long as that one. Pairs of which one is driven push
/// each other where they touch. They are charged for blows only: in the step in which the ball hits
/// one of them, or where they close faster than kBlowSpeed_mps. What presses without closing is the
/// motors' force, and the same without a ball.
class Pushes {
 public:
  /// `plan` must outlive this.
  explicit Pushes(const FigurePlan& plan) : plan_(plan) {}

  /// Before each step's other calls: the driving of what was hit long ago ends.
  void begin_step(double time_s);
  /// The ball hits `body` in this step.
  void hit(motion::Body body);
  /// Adds the pushes of this step.
  void add(const Figure& figure, const motion::PerBody<MovingShape>& shapes, Contacts& contacts);
  /// Whether a blow may fall within `horizon_s` as the bodies move now.
  bool ahead(const motion::PerBody<MovingShape>& shapes, double horizon_s) const;

 private:
  bool driven(motion::Body body) const { return driven_until_s_[body] > time_s_; }
  template <class Visit>
  void for_each_pair(Visit visit) const;

  const FigurePlan& plan_;
  double time_s_ = 0;
  motion::PerBody<double> driven_until_s_;
  motion::PerBody<bool> hit_now_;
};

}  // namespace flinch::sim
