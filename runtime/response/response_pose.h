// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "runtime/response/response.h"

namespace flinch::runtime {

/// The parts of a response's pose, each a function of time, for pose_at and for the planning of
/// responses. If `roles` are not all roles, the rotations of the others are not set.

/// Returns what the character does if it does not respond.
motion::Pose source_pose_at(const Response& response, float time_s,
                            std::span<const motion::Role> roles = motion::kRoles);
/// Returns the pose of the idle clip that continues after the response.
motion::Pose return_pose_at(const Response& response, float time_s,
                            std::span<const motion::Role> roles = motion::kRoles);
/// Returns the clip's pose, aligned.
motion::Pose clip_pose_at(const Response& response, float time_s,
                          std::span<const motion::Role> roles = motion::kRoles);

/// Position of a foot in each of these poses; in the source, where the foot stands.
motion::FootPose source_foot_in(const Response& response, motion::Side side,
                                const motion::Pose& source);
motion::FootPose clip_foot_in(const Response& response, motion::Side side, const motion::Pose& clip,
                              float time_s);
motion::FootPose source_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPose clip_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPose return_foot_at(const Response& response, motion::Side side, float time_s);

/// A pose is made in three stages. The first samples the motions that it blends, each once.
struct Samples {
  enum class Of : std::uint8_t {
    source_untouched,  ///< before the response: no weight is shifted
    source,
    source_and_clip,
    clip,
    clip_and_home,
    source_and_home,
    home,  ///< after the response
  };
  Of of = Of::source_untouched;
  float time_s = 0;
  motion::Pose from;               ///< the first of the blended poses
  std::optional<motion::Pose> to;  ///< the second, if there is one
};
Samples samples_at(const Response& response, float time_s,
                   std::span<const motion::Role> roles = motion::kRoles);

/// The second stage blends the joints, each separately.
motion::Pose blended(const Response& response, const Samples& samples,
                     std::span<const motion::Role> roles = motion::kRoles);

/// The third stage places the feet, with the weight shifted by `shift`, so that motion of the
/// pelvis does not move a foot. It turns thighs, shins and feet, and needs the roles of the legs
/// and the pelvis only.
struct Legs {
  motion::JointFrames frames;  ///< of the pelvis and the legs, before the feet are placed
  motion::PerSide<motion::FootPose> feet;  ///< target poses of the feet
};
bool must_place_feet(const Response& response, const Samples& samples,
                     const Eigen::Vector3f& shift);
Legs legs_of(const Response& response, const Samples& samples, const motion::Pose& blended);
void place_feet(const Response& response, const Legs& legs, const Eigen::Vector3f& shift,
                motion::Pose& pose);

/// Returns the displacement of the pelvis by weight shifts, world, m.
Eigen::Vector3f weight_shift_at(const Response& response, float time_s);

Eigen::Vector3f horizontal(const Eigen::Vector3f& vector);

}  // namespace flinch::runtime
