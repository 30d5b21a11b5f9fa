// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>

#include "motion/figure.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"
#include "tests/scenes/stance_clip.h"

namespace flinch::tests {

/// A walk along +X: feet that stand for 0.6 of the cycle exactly where they are, and swing for the
/// rest; the pelvis goes on at an even speed. Left and right differ by half a cycle.
struct Walk {
  float cycle_s = 1.1F;  ///< a whole number of frames at 60 Hz
  float speed_mps = 0.9F;
};

inline motion::FootPose walking_foot(const motion::Skeleton& skeleton, motion::Side side,
                                     const Walk& walk, float time_s) {
  constexpr float kStanding = 0.6F;
  const float stride_m = walk.speed_mps * walk.cycle_s;
  const float phase = time_s / walk.cycle_s + (side == motion::Side::left ? 0 : 0.5F);
  const float cycle = std::floor(phase);
  const float swing = std::max(phase - cycle - kStanding, 0.0F) / (1 - kStanding);
  const float ankle_height = motion::measure_foot(skeleton, side).ankle_height;
  // The pelvis passes the foot in the middle of its stand.
  const float x = stride_m * (cycle + 0.5F * kStanding - (side == motion::Side::left ? 0 : 0.5F) +
                              motion::minimum_jerk(swing));
  const float lift_m = 0.08F * std::pow(4 * swing * (1 - swing), 2.0F);
  const float y = skeleton.offset[motion::roles_of(motion::leg_of(side)).upper].y();
  return {{x, y, ankle_height + lift_m}, Eigen::Quaternionf::Identity()};
}

/// One cycle, as a stance has it.
inline motion::Motion walking(const motion::Figure& figure, const Walk& walk = {}) {
  const motion::Skeleton& skeleton = figure.skeleton();
  motion::Motion motion;
  motion.rate_hz = 60;
  const int count = static_cast<int>(std::lround(walk.cycle_s * motion.rate_hz));
  for (int k = 0; k < count; ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    motion::Pose pose = motion::rest_pose(skeleton);
    pose.root_position += Eigen::Vector3f(walk.speed_mps * time_s, 0, -0.06F);
    for (motion::Side side : motion::kSides) {
      const float swing = 0.4F * std::sin(2 * std::numbers::pi_v<float> * time_s / walk.cycle_s);
      motion::set_arm(pose, side, {motion::sign_of(side) * swing, 0.15F, 0, 0.4F});
    }
    pose = motion::with_feet(skeleton, pose,
                             {{{walking_foot(skeleton, motion::Side::left, walk, time_s),
                                walking_foot(skeleton, motion::Side::right, walk, time_s)}}});
    motion.poses.push_back(pose);
  }
  motion.poses.push_back(
      motion::placed(motion.poses.front(), 0, {walk.speed_mps * walk.cycle_s, 0, 0}));
  return motion;
}

/// The library with the walk as its last stance.
inline database::ClipLibrary with_walk(database::ClipLibrary library) {
  motion::Motion motion = walking(motion::make_figure(library.character));
  return with_stance(std::move(library), "walk", std::move(motion));
}

}  // namespace flinch::tests
