// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/ode/figure.h"

namespace flinch::reaction {

/// Holds the standing feet of a figure whose own springs are too weak to keep them in place.
/// Replaces the ground's support (see Figure::add_foot_support). A foot stands while its reference
/// is on the ground and does not move.
class FootLock {
 public:
  /// `figure_model` and `figure` must outlive this; `figure` has that model and is in that world.
  FootLock(const sim::FigureModel& figure_model, dWorldID world, sim::Figure& figure);

  /// Sets the hold for the next step, which ends at `target`. `share` scales its gains, see
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
