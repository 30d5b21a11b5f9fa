// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure.h"

namespace flinch::sim {

/// A motion that becomes known pose by pose, at any times. Between two poses every body moves with
/// the velocity that takes it from one to the other; beyond the last it goes on so.
class LiveReference {
 public:
  /// At time 0 the motion is at `now`, where it came to from `before` in `dt_s`. `plan` must
  /// outlive this.
  LiveReference(const FigurePlan& plan, const motion::Pose& before, const motion::Pose& now,
                double dt_s);

  /// The pose `dt_s` after the last.
  void add(const motion::Pose& pose, double dt_s);

  /// At a time no earlier than that of the pose before the last.
  ReferenceState at(double time_s) const;

 private:
  void move_to(const ReferenceState& next, double dt_s);

  const FigurePlan& plan_;
  ReferenceState last_;
  motion::PerBody<Eigen::Vector3d> socket_velocity_;
  double time_s_ = 0;
};

}  // namespace flinch::sim
