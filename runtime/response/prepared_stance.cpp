// SPDX-License-Identifier: MIT
#include "runtime/response/prepared_stance.h"

#include <limits>

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

/// Heights of both soles' lowest points, and how far the ankles are apart along the ground.
struct Feet {
  motion::PerSide<float> height;
  float apart_m = 0;
};

Feet feet_at(const motion::Skeleton& skeleton, const motion::PerSide<Sole>& soles,
             const motion::Loop& loop, float time_s) {
  const motion::JointFrames frames =
      motion::forward_kinematics(skeleton, motion::sample(loop, time_s));
  Feet feet;
  for (Side side : motion::kSides) feet.height[side] = min_height(soles[side], frames, side);
  feet.apart_m =
      (motion::foot_pose(frames, Side::left).ankle - motion::foot_pose(frames, Side::right).ankle)
          .head<2>()
          .norm();
  return feet;
}

// The standing foot is the lower one; where both stand, nothing passes.
Passing passing_of(const motion::Skeleton& skeleton, const motion::PerSide<Sole>& soles,
                   const motion::Loop& loop, Side standing) {
  const float frame_s = 1 / loop.motion().rate_hz;
  const Side swinging = motion::other(standing);
  Passing passing;
  float nearest_m = std::numeric_limits<float>::infinity();
  for (float time_s = 0; time_s < loop.period_s(); time_s += frame_s) {
    const Feet feet = feet_at(skeleton, soles, loop, time_s);
    if (feet.height[swinging] <= feet.height[standing] + kMaxStandingHeight_m) continue;
    if (feet.apart_m >= nearest_m) continue;
    nearest_m = feet.apart_m;
    passing.time_s = time_s;
  }
  while (passing.until_landing_s < loop.period_s()) {
    passing.until_landing_s += frame_s;
    const Feet feet = feet_at(skeleton, soles, loop, passing.time_s + passing.until_landing_s);
    if (feet.height[swinging] <= feet.height[standing] + kMaxStandingHeight_m) break;
  }
  return passing;
}

}  // namespace

PreparedStance prepare_stance(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                              const motion::PerSide<Sole>& soles, int clip,
                              const motion::Loop& loop) {
  PreparedStance stance;
  stance.clip = clip;
  stance.loop = loop;
  stance.bounds = features::motion_bounds_of(skeleton, bodies, loop.motion());
  if (!loop.travels()) return stance;
  for (Side side : motion::kSides) stance.passing[side] = passing_of(skeleton, soles, loop, side);
  return stance;
}

}  // namespace flinch::runtime
