// SPDX-License-Identifier: MIT
#pragma once

#include "features/scenario.h"
#include "motion/loop.h"

namespace flinch::features {

/// Bounds on the poses of a figure over some time, with which a sweep skips empty intervals.
struct MotionBounds {
  /// A sphere that the pelvis joint does not leave, m.
  Eigen::Vector3f pelvis_centre = Eigen::Vector3f::Zero();
  float radius = 0;
  float max_speed_mps = 0;  ///< of any point of the figure's surface; 0: it does not move
};

/// Returns the bounds of a figure that plays `motion` back and forth, in the frame of the motion.
/// For load time: takes a few microseconds per pose. `motion` has at least one pose. Allocates
/// nothing.
MotionBounds motion_bounds_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                              const motion::Motion& motion);

/// Returns the bounds of a character that goes on in its stance for `horizon_s`, world, from those
/// of the stance's motion.
MotionBounds placed(const MotionBounds& bounds, const motion::Loop& stance,
                    const CharacterState& state, float horizon_s);

/// Predicted poses of a figure: any function from the time after now, s, to the pose in the world,
/// with the bounds that these poses respect. Refers to the function, which must outlive it.
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
