// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "motion/skeleton.h"

namespace flinch::motion {

/// Which foot, or which arm.
enum class Side : std::uint8_t { left, right };

/// One value a side, left first.
template <class T>
using PerSide = std::array<T, 2>;

inline constexpr std::array<Side, 2> kSides{Side::left, Side::right};
constexpr std::size_t index_of(Side side) {
  return side == Side::left ? 0 : 1;
}
constexpr Side other(Side side) {
  return side == Side::left ? Side::right : Side::left;
}
/// +1 on the left, -1 on the right: the sign of y.
constexpr float sign_of(Side side) {
  return side == Side::left ? 1.0F : -1.0F;
}

/// A foot's roles.
struct FootRoles {
  Role foot;
  Role toes;
};
FootRoles roles_of(Side side);

/// Where an ankle is, world.
struct FootPose {
  Eigen::Vector3f ankle = Eigen::Vector3f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};
FootPose foot_pose(const JointFrames& frames, Side side);

/// Between two places: the ankle linearly, the orientation by slerp.
FootPose blend(const FootPose& from, const FootPose& to, float weight);

/// The lowest of points in a frame with this orientation, above the frame's origin, m; infinite of
/// no points.
float min_height(std::span<const Eigen::Vector3f> points, const Eigen::Quaternionf& orientation);

/// Size and place of a foot, in the frame of its joint in the rest pose, whose ankle stands above
/// the ground.
struct FootDimensions {
  Eigen::Vector3f forward;  ///< unit, horizontal, from below the ankle to the tip of the toes
  Eigen::Vector3f heel;     ///< where the heel's end stands on the ground, m
  float length;             ///< from the heel's end to the tip of the toes, m
  float ankle_height;       ///< of the joint above the ground, m
};

/// Skeletons do not say where the heel is: it is taken to reach behind the ankle by a quarter of
/// the foot's length, an estimate from mean adults.
FootDimensions measure_foot(const Skeleton& skeleton, Side side);

}  // namespace flinch::motion
