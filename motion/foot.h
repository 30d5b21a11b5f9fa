// SPDX-License-Identifier: MIT
#pragma once

#include "motion/skeleton.h"

namespace flinch::motion {

/// Which foot.
enum class Side : std::uint8_t { left, right };

/// A foot's roles.
struct FootRoles {
  Role foot;
  Role toes;
};
FootRoles roles_of(Side side);

/// Size and place of a foot, in the frame of its joint in the rest pose, whose ankle stands above
/// the ground.
struct FootMeasures {
  Eigen::Vector3f forward;  ///< unit, horizontal, from below the ankle to the tip of the toes
  Eigen::Vector3f heel;     ///< where the heel's end stands on the ground, m
  float length;             ///< from the heel's end to the tip of the toes, m
  float ankle_height;       ///< of the joint above the ground, m
};

/// Skeletons do not say where the heel is: it is taken to reach behind the ankle by a quarter of
/// the foot's length, an estimate from mean adults.
FootMeasures measure_foot(const Skeleton& skeleton, Side side);

}  // namespace flinch::motion
