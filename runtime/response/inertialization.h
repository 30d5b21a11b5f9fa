// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "features/scenario.h"
#include "motion/foot.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {

/// How a character that is not idling, but in another response or in a motion of the game's, comes
/// to idle: what its pose and velocities differ by from those of the idle clip, which dies away
/// without a snap. Feet that stand stay where they stand.
///
/// Each difference x follows a critically damped spring to 0,
///
///     x(t) = (x_0 + (v_0 + k x_0) t) e^(-k t),   k = kDecayRate.
struct Inertialization {
  bool is_zero = true;                                      ///< nothing differs
  Eigen::Vector3f root = Eigen::Vector3f::Zero();           ///< of the pelvis, world, m
  Eigen::Vector3f root_velocity = Eigen::Vector3f::Zero();  ///< m/s
  /// Rotation vectors that turn the idle pose's local rotations into the character's, radians.
  motion::PerRole<Eigen::Vector3f> rotation{};
  motion::PerRole<Eigen::Vector3f> rotation_velocity{};  ///< rad/s
  motion::PerSide<bool> stands{};                        ///< whether the foot is on the ground
  motion::PerSide<motion::FootPose> foot{};              ///< where, if it is
};

inline constexpr float kDecayRate = 10;  ///< 1/s

/// The state in which an idling character would stand as this one does: facing the same way, its
/// idle clip at its beginning, with the foot that carries more weight in the same place.
features::CharacterState idle_state_at(const PreparedLibrary& library, const motion::Pose& pose);

/// The origin of a character in `state` that was in pose `before` and `dt_s` later is in `now`.
/// `dt_s` that is not positive takes it to be still. Allocates nothing.
Inertialization make_inertialization(const PreparedLibrary& library,
                                     const features::CharacterState& state,
                                     const motion::Pose& before, const motion::Pose& now,
                                     float dt_s) noexcept;

/// The pose `time_s` later, if nothing answers. Feet are where the joints lead; see
/// Inertialization::foot. Where `roles` are not all, the rotations of others are not set.
motion::Pose inertialized_pose(const PreparedLibrary& library,
                               const features::CharacterState& state,
                               const Inertialization& inertialization, float time_s,
                               std::span<const motion::Role> roles = motion::kRoles) noexcept;

}  // namespace flinch::runtime
