// SPDX-License-Identifier: MIT
#pragma once

#include "features/scenario.h"

namespace flinch::features {

/// What bounds the poses of a figure over some time: what lets a sweep skip.
struct Sway {
  /// A sphere that the pelvis' joint does not leave, m.
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  float radius = 0;
  float most_speed_mps = 0;  ///< of any point of the figure's surface; 0: it holds still
};

/// How a figure sways that goes to and fro in `motion`, in the frame of the motion. For load time:
/// a few microseconds a pose. `motion` has at least one pose. Allocates nothing.
Sway sway_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
             const motion::Motion& motion);

/// The sway of an idling character where it stands, world, from that of its idle clip.
Sway placed(const Sway& sway, const CharacterState& state);

/// Where a figure will be: any function of the time from now, s, that gives its pose in the world,
/// with the sway that the function keeps to. Refers to the function, which must outlive it.
class PosesAhead {
 public:
  template <class PoseAt>
  PosesAhead(const PoseAt& pose_at, const Sway& sway)
      : function_(&pose_at), call_(&call<PoseAt>), sway_(sway) {}

  motion::Pose at(float time_s) const { return call_(function_, time_s); }
  const Sway& sway() const { return sway_; }

 private:
  template <class PoseAt>
  static motion::Pose call(const void* function, float time_s) {
    return (*static_cast<const PoseAt*>(function))(time_s);
  }

  const void* function_;
  motion::Pose (*call_)(const void*, float);
  Sway sway_;
};

}  // namespace flinch::features
