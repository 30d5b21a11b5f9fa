// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/ode/figure.h"

namespace flinch::reaction {

/// The grip of the ground on the feet that stand, for a figure whose own springs are too weak to
/// keep them in place: in place of the ground's support (see Figure::add_foot_support). A foot
/// stands while its reference lies on the ground and keeps still.
class FootLock {
 public:
  /// `figure_model` must outlive this; `figure` is of that plan and in that world, and must
  /// outlive this too.
  FootLock(const sim::FigureModel& figure_model, dWorldID world, sim::Figure& figure);

  /// Sets the grip for the next step, at whose end `target` is wanted; `share` of it, see
  /// scaled_gains.
  void lock(const sim::ReferenceState& target, double step_s, double share);
  void unlock();

 private:
  struct Foot {
    motion::Body body;
    dBodyID part;
    dJointID place;
    dJointID angular;
  };
  void set_locked(const Foot& foot, bool locked);

  const sim::FigureModel& figure_model_;
  sim::Figure& figure_;
  std::array<Foot, 2> feet_;
};

}  // namespace flinch::reaction
