// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "runtime/response/response.h"

namespace flinch::runtime {

/// The parts that a response's pose is made of, each a function of time, for pose_at and for the
/// planning of responses. Where `roles` are not all, the rotations of others are not set.

/// What the character does if nothing answers.
motion::Pose source_pose_at(const Response& response, float time_s,
                            std::span<const motion::Role> roles = motion::kRoles);
/// The idle clip where it goes on after the response.
motion::Pose return_pose_at(const Response& response, float time_s,
                            std::span<const motion::Role> roles = motion::kRoles);
/// The clip's pose, aligned.
motion::Pose clip_pose_at(const Response& response, float time_s,
                          std::span<const motion::Role> roles = motion::kRoles);

/// Where a foot is in each of them; of the source, where it stands.
motion::FootPose source_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPose clip_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPose return_foot_at(const Response& response, motion::Side side, float time_s);

/// The clip's foot as it is before its plan changes it.
motion::FootPose uncorrected_clip_foot_at(const Response& response, motion::Side side,
                                          float time_s);

Eigen::Vector3f horizontal(const Eigen::Vector3f& vector);

}  // namespace flinch::runtime
