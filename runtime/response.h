// SPDX-License-Identifier: MIT
#pragma once

#include "database/library.h"
#include "features/scenario.h"

namespace flinch::runtime {

/// The motion that answers a scenario with a clip: made by this one piece of code for the trainer
/// and for the game. Refers to the library that it was made from, which must outlive it.
///
/// The character idles until `begin_s`, then plays the clip from its onset at `playback_rate`,
/// blending in over `blend_s`, so that the clip's peak falls on the predicted impact; a clip too
/// long for that plays faster, up to kMostPlaybackRate, and may peak late. The clip is aligned with
/// the idle pose at `begin_s` by pelvis position and facing. After the clip it blends back to idle.
struct Response {
  const database::Library* library = nullptr;
  int clip = 0;  ///< index in the library; its idle clip means to do nothing
  features::CharacterState state;
  float begin_s = 0;        ///< when the clip begins, from perception
  float playback_rate = 1;  ///< clip seconds a second
  float blend_s = 0;        ///< length of the blend into the clip, and back
  float end_s = 0;          ///< when the clip's end is reached; the way back follows
  float yaw = 0;            ///< turn that aligns the clip, radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< that aligns it, after the turn, m
};

inline constexpr float kMostPlaybackRate = 1.4F;
inline constexpr float kBlend = 0.2F;  ///< s

/// Plans the response of a character in `state` with clip number `clip`, which must be annotated or
/// the library's idle clip, to an impact predicted in `time_to_impact_s` (positive).
Response make_response(const database::Library& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s);

/// The pose `time_s` after perception. Any time from 0 on; continuous. Allocates nothing.
motion::Pose pose_at(const Response& response, float time_s);

/// When the way back to idle is over, s from perception; 0 for the idle clip.
float duration_s(const Response& response);

}  // namespace flinch::runtime
