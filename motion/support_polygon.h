// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/foot.h"

namespace flinch::motion {

/// Outline of a sole in the frames of its joints, m, counter-clockwise seen from above.
struct SoleOutline {
  std::vector<Eigen::Vector3f> foot;  ///< heel to ball, in the foot's frame
  std::vector<Eigen::Vector3f> toes;  ///< ball to tip, in the toes' frame
};

/// Returns the sole of a skeleton's foot: a mean adult footprint scaled to the foot's length (see
/// measure_foot). It is flat on the ground in the rest pose.
SoleOutline sole_outline(const Skeleton& skeleton, Side side);
/// Returns the soles of both feet.
PerSide<SoleOutline> sole_outlines(const Skeleton& skeleton);

/// Returns the points of a sole in the world, m: those of the foot, then those of the toes. For
/// offline use: allocates.
std::vector<Eigen::Vector3f> sole_points(const SoleOutline& sole, const JointFrames& frames,
                                         Side side);

/// Returns the z of the lowest of these points, m; infinity for no points.
float lowest_z(std::span<const Eigen::Vector3f> points);

/// Returns the support foot: of the sides for which `stands` returns true, the one whose ankle is
/// nearer to the centre of mass as seen from above, the left one on a tie; nothing where neither
/// stands. `ankle_of` returns a side's ankle, world.
template <class Stands, class AnkleOf>
std::optional<Side> support_foot(const Eigen::Vector3f& centre, Stands stands, AnkleOf ankle_of) {
  std::optional<Side> support;
  float nearest = 0;
  for (Side side : kSides) {
    if (!stands(side)) continue;
    const float distance = (ankle_of(side) - centre).template head<2>().norm();
    if (support && distance >= nearest) continue;
    support = side;
    nearest = distance;
  }
  return support;
}

/// Returns the convex hull of points, counter-clockwise, without repeated or collinear points.
std::vector<Eigen::Vector2f> convex_hull(std::vector<Eigen::Vector2f> points);

/// Returns the convex hull, on the ground, of all sole points within `tolerance_m` of the ground:
/// counter-clockwise, world x and y, m, without repeated or collinear points. Empty when no foot
/// touches. For offline use: allocates.
std::vector<Eigen::Vector2f> support_polygon(const Skeleton& skeleton, const JointFrames& frames,
                                             float tolerance_m = 0.03F);

/// Distance between a point and the nearest edge of a convex counter-clockwise polygon, m: positive
/// inside, negative outside and for a polygon of one or two points; minus infinity for an empty
/// one.
float signed_distance_inside(const std::vector<Eigen::Vector2f>& polygon,
                             const Eigen::Vector2f& point);
/// Returns how far a point must go toward a goal to be at least `margin` inside of a convex
/// counter-clockwise polygon, as a fraction of the way: 0 where it is already, 1 where only the
/// goal is, or not even that.
float fraction_to_inside(float margin, const std::vector<Eigen::Vector2f>& polygon,
                         const Eigen::Vector2f& point, const Eigen::Vector2f& goal);

}  // namespace flinch::motion
