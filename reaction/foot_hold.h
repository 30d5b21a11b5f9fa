// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/ode/figure.h"

namespace flinch::reaction {

/// The grip of the ground on the feet that stand, for a figure whose own springs are too weak to
/// keep them in place: in place of the ground's support (see Figure::stand). A foot stands while
/// its reference lies on the ground and keeps still.
class FootHold {
 public:
  /// `plan` must outlive this; `figure` is of that plan and in that world, and must
  /// outlive this too.
  FootHold(const sim::FigurePlan& plan, dWorldID world, sim::Figure& figure);

  /// Sets the grip for the next step, at whose end `target` is wanted; `share` of it, see weakened.
  void hold(const sim::ReferenceState& target, double step_s, double share);
  void let_go();

 private:
  struct Foot {
    motion::Body body;
    dBodyID part;
    dJointID place;
    dJointID turning;
  };
  void set_held(const Foot& foot, bool held);

  const sim::FigurePlan& plan_;
  sim::Figure& figure_;
  std::array<Foot, 2> feet_;
};

}  // namespace flinch::reaction
