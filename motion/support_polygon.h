// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "motion/skeleton.h"

namespace flinch::motion {

/// Which foot.
enum class Side : std::uint8_t { left, right };

/// Outline of a sole in the frames of its joints, m, counter-clockwise seen from above.
struct SoleOutline {
  std::vector<Eigen::Vector3f> foot;  ///< heel to ball, in the foot's frame
  std::vector<Eigen::Vector3f> toes;  ///< ball to tip, in the toes' frame
};

/// The sole of a skeleton's foot, scaled from a mean adult footprint to its foot length.
SoleOutline sole_outline(const Skeleton& skeleton, Side side);

/// The convex hull on the ground of all sole points that are within `tolerance_m` of it,
/// counter-clockwise, world x and y, m. Empty when no foot touches.
std::vector<Eigen::Vector2f> support_polygon(const Skeleton& skeleton, const JointFrames& frames,
                                             float tolerance_m = 0.03F);

/// Signed distance of a point to a convex counter-clockwise polygon's edge, m: positive inside,
/// negative outside; minus infinity for an empty polygon.
float signed_distance_inside(const std::vector<Eigen::Vector2f>& polygon,
                             const Eigen::Vector2f& point);

}  // namespace flinch::motion
