// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "motion/foot.h"

namespace flinch::motion {

/// Outline of a sole in the frames of its joints, m, counter-clockwise seen from above.
struct SoleOutline {
  std::vector<Eigen::Vector3f> foot;  ///< heel to ball, in the foot's frame
  std::vector<Eigen::Vector3f> toes;  ///< ball to tip, in the toes' frame
};

/// The sole of a skeleton's foot, scaled from a mean adult footprint to its foot length (see
/// measure_foot). Flat on the ground in the rest pose.
SoleOutline sole_outline(const Skeleton& skeleton, Side side);

/// The convex hull of points, counter-clockwise, without repeated or collinear ones.
std::vector<Eigen::Vector2f> convex_hull(std::vector<Eigen::Vector2f> points);

/// The convex hull on the ground of all sole points that are within `tolerance_m` of it,
/// counter-clockwise, world x and y, m, without repeated or collinear points. Empty when no foot
/// touches. For offline use: allocates.
std::vector<Eigen::Vector2f> support_polygon(const Skeleton& skeleton, const JointFrames& frames,
                                             float tolerance_m = 0.03F);

/// Distance of a point to the nearest edge of a convex counter-clockwise polygon, m: positive
/// inside, negative outside, also of a polygon of one or two points; minus infinity for none.
float signed_distance_inside(const std::vector<Eigen::Vector2f>& polygon,
                             const Eigen::Vector2f& point);
/// Whether that is at least `margin`, 0 or above: the first edge that is nearer will do.
bool is_inside_by(float margin, const std::vector<Eigen::Vector2f>& polygon,
                  const Eigen::Vector2f& point);

}  // namespace flinch::motion
