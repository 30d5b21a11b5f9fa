// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"

namespace flinch::runtime {

/// C of Arikan et al. 2005, section 3: positions of all joints (m), then their velocities times
/// kVelocityWeight_s. In the frame of the facing, with its origin on the ground below the pelvis.
using BodyConfiguration = Eigen::Matrix<float, 6 * motion::kRoleCount, 1>;

/// What makes a velocity comparable to a place, s: that by which it moves a joint in this time.
inline constexpr float kVelocityWeight_s = 0.1F;

/// The configuration of a character in pose `now` that was in pose `before` `dt_s` (above 0)
/// earlier; world. Allocates nothing.
BodyConfiguration body_configuration(const motion::Skeleton& skeleton, const motion::Pose& before,
                                     const motion::Pose& now, float dt_s) noexcept;

}  // namespace flinch::runtime
