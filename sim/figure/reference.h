// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"
#include "sim/body_state.h"

namespace flinch::sim {

/// Pose and velocity of the reference motion at one time.
struct ReferenceState {
  motion::PerBody<BodyState> body;
  /// Position of the joint to the parent, from the parent's centre of mass in the parent's frame,
  /// m. The joints of the upper arms move, because the clavicles belong to the chest. The pelvis
  /// has none.
  motion::PerBody<Eigen::Vector3d> socket;
};

/// Returns the figure in a pose, at rest.
ReferenceState state_at_rest(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                             const motion::Pose& pose);

/// The motion that the motors track. Velocities are central differences over two frames,
/// interpolated; beyond the last pose the figure holds still.
class Reference {
 public:
  /// Keeps references to all three arguments, which must outlive it.
  Reference(const motion::Skeleton& skeleton, const motion::BodyModel& model,
            const motion::Motion& motion);

  ReferenceState at(double time_s) const;
  /// Bytes held in addition to sizeof this.
  std::size_t byte_count() const { return velocities_.capacity() * sizeof(Velocities); }

 private:
  struct Velocities {  // as precise as the poses that they are differences of
    motion::PerBody<Eigen::Vector3f> linear;
    motion::PerBody<Eigen::Vector3f> angular;
  };
  const motion::Skeleton& skeleton_;
  const motion::BodyModel& model_;
  const motion::Motion& motion_;
  std::vector<Velocities> velocities_;  // one per pose
};

/// The state of a reference at some time, computed when it is first needed, which it may never be.
/// For one thread.
class ReferenceOnDemand {
 public:
  /// A state that is known. It must outlive this.
  ReferenceOnDemand(const ReferenceState& state) : state_(&state) {}
  /// `reference` must outlive this.
  ReferenceOnDemand(const Reference& reference, double time_s)
      : reference_(&reference), time_s_(time_s) {}

  const ReferenceState& get() const {
    if (state_) return *state_;
    if (!computed_) computed_ = reference_->at(time_s_);
    return *computed_;
  }

 private:
  const ReferenceState* state_ = nullptr;
  const Reference* reference_ = nullptr;
  double time_s_ = 0;
  mutable std::optional<ReferenceState> computed_;
};

}  // namespace flinch::sim
