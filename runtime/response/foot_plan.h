// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "runtime/response/footwork.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {

/// Where the feet go while a response begins.

inline constexpr float kStepDuration_s = 0.25F;      // of a step that is not in the clip
inline constexpr float kMinShiftDuration_s = 0.15F;  // of a weight shift

/// What is blended when the clip begins.
struct Start {
  motion::Pose source;
  motion::Pose clip;
};

/// Whether two places on the ground are farther apart than that.
bool differ(const motion::FootPose& a, const motion::FootPose& b, float distance_m, float yaw);

/// Returns how high a foot is lifted that steps from one place to another, m.
float step_height(const motion::FootPose& from, const motion::FootPose& to);

/// Of the response's clip; a response by rule has none.
const Footwork& footwork_of(const Response& response);

/// Plans how a foot gets from where it is to where the clip has it.
void plan_foot(Response& response, motion::Side side, const Start& start);

/// When the foot that is not the support first leaves the ground, if it does before the clip's
/// peak, s after perception.
std::optional<float> first_lift_s(const Response& response);

}  // namespace flinch::runtime
