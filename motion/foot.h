// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "motion/enum_array.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// The side of a foot, leg or arm.
enum class Side : std::uint8_t { left, right };

/// The number of sides.
inline constexpr int kSideCount = 2;
/// Both sides, for range-based loops.
inline constexpr auto kSides = all_enumerators<Side, kSideCount>();

/// One value per side, left first.
template <class T>
using PerSide = EnumArray<Side, T, kSideCount>;

/// The opposite side.
constexpr Side other(Side side) {
  return side == Side::left ? Side::right : Side::left;
}
/// +1 on the left, -1 on the right: the sign of y.
constexpr float sign_of(Side side) {
  return side == Side::left ? 1.0F : -1.0F;
}

/// The roles of one foot.
struct FootRoles {
  Role foot;
  Role toes;
};
/// The roles of the foot on this side.
FootRoles roles_of(Side side);

/// Position and orientation of a foot, world.
struct FootPose {
  Eigen::Vector3f ankle = Eigen::Vector3f::Zero();  ///< of the foot's joint, m
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};
/// The foot of a pose.
FootPose foot_pose(const JointFrames& frames, Side side);

/// Interpolates: the ankle linearly, the orientation by slerp. `weight` 0 is `from`, 1 is `to`.
FootPose blend(const FootPose& from, const FootPose& to, float weight);

/// The height of the lowest of `points`, which are in a frame with this orientation, above the
/// origin of the frame, m; infinite without points.
float min_height(std::span<const Eigen::Vector3f> points, const Eigen::Quaternionf& orientation);

/// Dimensions of a foot, in the frame of its joint in the rest pose, in which the ankle is above
/// the ground.
struct FootDimensions {
  Eigen::Vector3f forward;  ///< unit, horizontal, from below the ankle to the tip of the toes
  Eigen::Vector3f heel;     ///< the end of the heel on the ground, m
  float length;             ///< from the heel's end to the tip of the toes, m
  float ankle_height;       ///< of the joint above the ground, m
};

/// Measures a foot. Skeletons do not say where the heel is: it is assumed a quarter of the foot's
/// length behind the ankle, an estimate from mean adults.
FootDimensions measure_foot(const Skeleton& skeleton, Side side);

}  // namespace flinch::motion
