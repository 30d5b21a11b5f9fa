// SPDX-License-Identifier: MIT
#pragma once

#include "sim/ode/figure.h"

namespace flinch::reaction {

/// A motion that becomes known pose by pose, at any times, for a simulation that runs ahead of it.
/// Between two poses every body moves with the velocity that takes it from one to the other; beyond
/// the last it goes on so. Where the next pose turns out to be elsewhere, the difference goes over
/// a step's time, so that the reference never jumps and its velocity is that of its path.
class LiveReference {
 public:
  /// At time 0 the motion is at `now`, where it came to from `before` in `dt_s`. `figure_model`
  /// must outlive this.
  LiveReference(const sim::FigureModel& figure_model, const motion::Pose& before,
                const motion::Pose& now, double dt_s);

  /// The pose `dt_s` after the last. The simulation has come to `simulated_until_s`.
  void add(const motion::Pose& pose, double dt_s, double simulated_until_s);

  /// At a time that the simulation has not gone beyond.
  sim::ReferenceState at(double time_s) const;

 private:
  /// What a pose turned out to be short of, in the order of ReferenceState.
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
