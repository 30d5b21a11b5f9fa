// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "motion/body.h"
#include "motion/clip.h"
#include "sim/body_state.h"

namespace flinch::sim {

/// Where a reference motion has the figure at one time, and how fast it moves.
struct ReferenceState {
  motion::PerBody<BodyState> body;
  /// The joint to the parent, from the parent's centre of mass in the parent's frame, m. Those of
  /// the upper arms move: the clavicles belong to the chest. The pelvis has none.
  motion::PerBody<Eigen::Vector3d> socket;
};

/// Where a pose has the figure, at rest.
ReferenceState state_at_rest(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                             const motion::Pose& pose);

/// A motion as the controller wants it. Velocities are central differences over two frames,
/// interpolated; beyond the last pose the figure holds still.
class Reference {
 public:
  /// Keeps references to all three, which must outlive it.
  Reference(const motion::Skeleton& skeleton, const motion::BodyModel& model,
            const motion::Motion& motion);

  ReferenceState at(double time_s) const;
  /// Beyond its own size.
  std::size_t byte_count() const { return velocities_.capacity() * sizeof(Velocities); }

 private:
  struct Velocities {
    motion::PerBody<Eigen::Vector3d> linear;
    motion::PerBody<Eigen::Vector3d> angular;
  };
  const motion::Skeleton& skeleton_;
  const motion::BodyModel& model_;
  const motion::Motion& motion_;
  std::vector<Velocities> velocities_;  // a pose
};

}  // namespace flinch::sim
