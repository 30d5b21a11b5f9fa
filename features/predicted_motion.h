// SPDX-License-Identifier: MIT
#pragma once

#include "features/scenario.h"

namespace flinch::features {

/// What bounds the poses of a figure over some time: what lets a sweep skip.
struct MotionBounds {
  /// A sphere that the pelvis' joint does not leave, m.
  Eigen::Vector3f pelvis_centre = Eigen::Vector3f::Zero();
  float radius = 0;
  float max_speed_mps = 0;  ///< of any point of the figure's surface; 0: it holds still
};

/// How a figure sways that goes to and fro in `motion`, in the frame of the motion. For load time:
/// a few microseconds a pose. `motion` has at least one pose. Allocates nothing.
MotionBounds motion_bounds_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                              const motion::Motion& motion);

/// The sway of an idling character where it stands, world, from that of its idle clip.
MotionBounds placed(const MotionBounds& bounds, const CharacterState& state);

/// Where a figure will be: any function of the time from now, s, that gives its pose in the world,
/// with the sway that the function keeps to. Refers to the function, which must outlive it.
class PredictedMotion {
 public:
  template <class PoseAt>
  PredictedMotion(const PoseAt& pose_at, const MotionBounds& bounds)
      : function_(&pose_at), call_(&call<PoseAt>), bounds_(bounds) {}

  motion::Pose at(float time_s) const { return call_(function_, time_s); }
  const MotionBounds& bounds() const { return bounds_; }

 private:
  template <class PoseAt>
  static motion::Pose call(const void* function, float time_s) {
    return (*static_cast<const PoseAt*>(function))(time_s);
  }

  const void* function_;
  motion::Pose (*call_)(const void*, float);
  MotionBounds bounds_;
};

}  // namespace flinch::features
