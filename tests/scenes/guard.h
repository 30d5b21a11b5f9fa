// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "motion/figure.h"
#include "tests/scenes/stance_clip.h"

namespace flinch::tests {

/// One cycle of a crouch with raised hands, which sways sideways, as a stance has it.
inline motion::Motion guarding(const motion::Figure& figure) {
  constexpr float kCycle_s = 2;
  const motion::Skeleton& skeleton = figure.skeleton();
  const motion::Pose rest = motion::rest_pose(skeleton);
  const motion::JointFrames standing = motion::forward_kinematics(skeleton, rest);
  motion::PerSide<motion::FootPose> feet;
  for (const motion::Side side : motion::kSides) feet[side] = motion::foot_pose(standing, side);
  motion::Motion motion;
  motion.rate_hz = 60;
  const int count = static_cast<int>(std::lround(kCycle_s * motion.rate_hz));
  for (int k = 0; k <= count; ++k) {
    const float phase = static_cast<float>(k % count) / static_cast<float>(count);
    motion::Pose pose = rest;
    pose.root_position +=
        Eigen::Vector3f(0, 0.02F * std::sin(2 * std::numbers::pi_v<float> * phase), -0.2F);
    for (const motion::Side side : motion::kSides)
      motion::set_arm(pose, side, {.flexion = 0.6F, .abduction = 0.15F, .elbow = 2});
    motion.poses.push_back(motion::with_feet(skeleton, pose, feet));
  }
  return motion;
}

/// The library with the guard as its last stance.
inline database::ClipLibrary with_guard(database::ClipLibrary library) {
  motion::Motion motion = guarding(motion::make_figure(library.character));
  return with_stance(std::move(library), "guard", std::move(motion));
}

}  // namespace flinch::tests
