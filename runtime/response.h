// SPDX-License-Identifier: MIT
#pragma once

#include "database/library.h"
#include "features/scenario.h"

namespace flinch::runtime {

/// The motion that answers a scenario with a clip: made by this one piece of code for the trainer
/// and for the game. A plain value; refers to the library that it was made from, which must outlive
/// it and stay as it is.
///
/// The character idles until `begin_s`, then plays the clip from its onset at `playback_rate`,
/// blending in by ease-in ease-out over `blend_s` while the clip already plays, so that the clip's
/// peak falls on the predicted impact; a clip too long for that plays faster, up to
/// kMostPlaybackRate, and may peak late. From the clip's annotated end it blends back to idle over
/// kBlend, while the clip plays on to its last pose and holds that.
///
/// Alignment. Directions are annotated relative to the actor's facing, and clips are stored facing
/// +X, while the pelvis of a boxer may be turned from it. So the clip's +X axis is laid on the
/// character's facing (CharacterState::facing), not pelvis on pelvis; and the pelvis of the clip's
/// pose at its onset is moved horizontally over that of the idle pose at `begin_s`.
///
/// The way back. Where the clip took a step, the idle goes on there: it is moved horizontally by
/// `travel`, which brings the idle pelvis to where the clip's is when the way back is over. The
/// next state of the character is this one with `travel` added to its position. A turn of the
/// facing is not kept: the idle faces as before.
struct Response {
  const database::Library* library = nullptr;  ///< none: invalid
  int clip = 0;  ///< index in the library; its idle clip means to do nothing
  features::CharacterState state;
  float begin_s = 0;        ///< when the clip begins, from perception
  float playback_rate = 1;  ///< clip seconds a second
  float blend_s = 0;        ///< length of the blend into the clip, at most the way to the peak
  float end_s = 0;          ///< when the clip's annotated end is reached; the way back follows
  float yaw = 0;            ///< turn that aligns the clip, radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< that aligns it, after the turn, m
  Eigen::Vector3f travel = Eigen::Vector3f::Zero();  ///< of the idle after the response, level, m
};

inline constexpr float kMostPlaybackRate = 1.4F;
inline constexpr float kBlend = 0.2F;  ///< s

/// Plans the response of a character in `state` with clip number `clip`, which must be annotated or
/// the library's idle clip, to an impact predicted in `time_to_impact_s` (positive, finite). Input
/// that cannot be used (no such clip, no annotation, times out of order, no poses, a state that is
/// not finite) gives an invalid response. Allocates nothing, throws nothing.
Response make_response(const database::Library& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s) noexcept;

/// Whether make_response could use its input.
bool is_valid(const Response& response) noexcept;

/// The pose `time_s` after perception, world. Any time from 0 on, continuous over it; a time that
/// is negative or not finite is taken as 0. Of an invalid response, the pose of no motion at the
/// world's origin. Costs a few microseconds; allocates nothing, throws nothing.
motion::Pose pose_at(const Response& response, float time_s) noexcept;

/// When the way back to idle is over, s from perception; 0 for the idle clip.
float duration_s(const Response& response) noexcept;

}  // namespace flinch::runtime
