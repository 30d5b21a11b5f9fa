// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "features/scenario.h"
#include "motion/foot.h"

namespace flinch::runtime {

struct PreparedLibrary;  // opaque: runtime::Library::prepared()

/// How a character that is in another response, that the game animates or that leaves a walk
/// differs from the stance in which it comes to rest: its own or, if that travels, the idle clip
/// (PreparedLibrary::rest_of). The difference decays smoothly to none; feet on the ground stay
/// where they are.
///
/// Each difference x follows a critically damped spring to 0,
///
///     x(t) = (x_0 + (v_0 + k x_0) t) e^(-k t),   k = kDecayRate.
///
/// A joint that would swing past its limit on the way has a larger k. A wrist that is bent and
/// turned would leave its limits on the straight way itself, by up to 0.14 rad: it keeps to them,
/// or as far beyond as it was.
struct Inertialization {
  bool is_zero = true;                                      ///< no difference
  Eigen::Vector3f root = Eigen::Vector3f::Zero();           ///< x_0 of the pelvis, world, m
  Eigen::Vector3f root_velocity = Eigen::Vector3f::Zero();  ///< v_0 of the pelvis, m/s
  /// x_0 of each joint: the rotation vector that turns the idle pose's local rotation into the
  /// character's, radians.
  motion::PerRole<Eigen::Vector3f> rotation{};
  motion::PerRole<Eigen::Vector3f> rotation_velocity{};  ///< v_0 of each joint, radians/s
  motion::PerRole<float> stiffening{};       ///< added to kDecayRate for the k of each joint, 1/s
  motion::PerSide<bool> stands{};            ///< whether the foot is on the ground
  motion::PerSide<motion::FootPose> foot{};  ///< where it stands, if it does
};

/// k: how fast differences decay, 1/s.
inline constexpr float kDecayRate = 10;

/// The state of a character that rests where this pose stands: it faces the same way, the clip in
/// which it rests is at its beginning, and the foot that carries more weight is in the same place.
/// Its stance is number `stance`. `pose` is in the world and sound (motion::is_sound). `facing`
/// overrides the direction that the feet tell.
features::CharacterState rest_state_at(const PreparedLibrary& library, const motion::Pose& pose,
                                       int stance, std::optional<float> facing = std::nullopt);

/// The difference between resting in `state` and a character that was in pose `before` and is
/// in `now` `dt_s` later; poses in the world. A `dt_s` that is not positive means that the
/// character is still. Allocates nothing.
Inertialization make_inertialization(const PreparedLibrary& library,
                                     const features::CharacterState& state,
                                     const motion::Pose& before, const motion::Pose& now,
                                     float dt_s) noexcept;

/// The pose `time_s` after the difference was measured, world: the resting character with what is
/// left of the difference. Without a difference, the character goes on in its stance. Feet follow
/// from the joints, not from Inertialization::foot. Sets the rotations of `roles` only. Allocates
/// nothing.
motion::Pose inertialized_pose(const PreparedLibrary& library,
                               const features::CharacterState& state,
                               const Inertialization& inertialization, float time_s,
                               std::span<const motion::Role> roles = motion::kRoles) noexcept;

}  // namespace flinch::runtime
