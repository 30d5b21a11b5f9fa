// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure/figure_rows.h"

namespace flinch::reaction {

/// A motion that becomes known pose by pose, at any times, for a simulation that runs ahead of it.
/// Between two poses every body moves with the velocity that leads from one to the other; after the
/// last pose it keeps that velocity. If the next pose differs from this extrapolation, the
/// difference is blended in over a step's time, so that the reference never jumps and its velocity
/// is that of its path.
class LiveReference {
 public:
  /// At time 0 the motion is at `now`, which it reached from `before` in `dt_s`. `figure_model`
  /// must outlive this.
  LiveReference(const sim::FigureModel& figure_model, const motion::Pose& before,
                const motion::Pose& now, double dt_s);

  /// Adds the pose `dt_s` after the last. The simulation has reached `simulated_until_s`.
  void add(const motion::Pose& pose, double dt_s, double simulated_until_s);

  /// Returns the state at a time that is not before the time which the simulation has reached.
  sim::ReferenceState at(double time_s) const;

 private:
  /// The extrapolation less the pose that followed, in the order of ReferenceState.
  struct Correction {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    Eigen::Vector3d socket = Eigen::Vector3d::Zero();
  };
  void move_to(const sim::ReferenceState& next, double dt_s);
  sim::ReferenceState extrapolated(double time_s) const;

  const sim::FigureModel& figure_model_;
  sim::ReferenceState last_;
  motion::PerBody<Eigen::Vector3d> socket_velocity_;
  double time_s_ = 0;
  motion::PerBody<Correction> corrections_;  // at the time that the simulation had reached
  double correction_begin_s_ = 0;
};

}  // namespace flinch::reaction
