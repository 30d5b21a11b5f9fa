// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/figure/reference.h"
#include "sim/tree/joint_tree.h"

namespace flinch::lookahead {

/// Where a simulated figure is that has followed its reference for a while: it lags behind by what
/// its springs give under the weight and the inertia of its parts. figure_lag.cpp has the
/// equations.
class FigureLag {
 public:
  /// `figure_model` must outlive this.
  explicit FigureLag(const sim::FigureModel& figure_model)
      : figure_model_(figure_model), tree_(figure_model) {}

  /// The reference at four successive steps.
  struct Steps {
    motion::PerBody<sim::BodyState> two_before, before;
    sim::ReferenceState now;
    motion::PerBody<sim::BodyState> after;
  };
  /// Returns the figure at `steps.now`, with the velocities that a step of `step_s` gives it.
  motion::PerBody<sim::BodyState> figure(const Steps& steps, double step_s, double gravity_mps2);

 private:
  const sim::FigureModel& figure_model_;
  sim::JointTree tree_;
};

}  // namespace flinch::lookahead
