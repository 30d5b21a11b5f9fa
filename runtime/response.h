// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "motion/interpolation.h"
#include "runtime/origin.h"
#include "runtime/prepared_library.h"

namespace flinch::runtime {

/// A rigid move of the ground: a turn about the world's vertical through the origin, then a shift.
struct GroundMove {
  float yaw = 0;                                          ///< radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< level, m
};

/// A stretch of time over which something goes over, from perception, s.
struct Window {
  float begin_s = std::numeric_limits<float>::infinity();
  float end_s = std::numeric_limits<float>::infinity();
};

/// How one foot of a response differs from that of its clip, so that it leaves from where it
/// stands.
struct FootPlan {
  GroundMove offset;  ///< of the clip's foot until `change` begins; over `change` it goes over
  Window change;      ///< to none, in a swing of the clip's or in a step of its own
  float change_lift_m = 0;  ///< height of that step; 0 in the clip's own swing
  Window home;              ///< the way back to where the idle clip has the foot
  float home_lift_m = 0;
  /// Height and tilt by which the foot differs from its clip's, offset and all, when the clip
  /// begins: the blend takes them back.
  Eigen::Vector3f rise = Eigen::Vector3f::Zero();
  Eigen::Quaternionf tilt = Eigen::Quaternionf::Identity();
};

/// A shift of the weight: the pelvis moves by `pelvis` until the centre of mass is above the sole
/// of the support foot, stays over `held`, in which the other foot leaves the ground, and comes
/// back.
struct WeightShift {
  Window window;
  Window held;
  Eigen::Vector3f pelvis = Eigen::Vector3f::Zero();  ///< world, m
};

/// The motion that answers a scenario with a clip: made by this one piece of code for the trainer
/// and for the game. A plain value; refers to the library that it was made from, which must outlive
/// it and stay as it is. docs/response.md tells why it is as it is.
///
/// The character idles (or settles, see Origin) until `begin_s`, then plays the clip from its onset
/// at `playback_rate`, blending in along minimum_jerk over `blend_s` while the clip already plays,
/// so that the clip's peak falls on the predicted impact; a clip too long for that plays faster, up
/// to kMostPlaybackRate, and may peak late. From the clip's annotated end it blends back to idle
/// over `return_s`, while the clip plays on to its last pose and holds that.
///
/// Alignment (Zordan et al. 2007, section 6). Directions are annotated relative to the actor's
/// facing, and clips are stored facing +X, so the clip's +X axis is laid on the character's facing;
/// and the support foot, the one that carries more weight in the clip's opening, is laid on where
/// the character has it. Feet that stand stay: where the clip has a foot elsewhere it goes there in
/// the clip's own next swing of that foot, or, from far, in a small step. Before the other foot
/// leaves the ground the weight is shifted over the support foot.
///
/// The way back. Where the clip took a step, the idle goes on there: it is moved horizontally by
/// `travel`. The next state of the character is this one with `travel` added to its position. A
/// turn of the facing is not kept: the idle faces as before, and feet step back into place.
struct Response {
  const PreparedLibrary* library = nullptr;  ///< none: invalid
  int clip = 0;  ///< index in the library; its idle clip means to do nothing
  features::CharacterState state;
  Origin origin;
  float start_s = 0;        ///< when it first differs from idling
  float begin_s = 0;        ///< when the clip begins, from perception
  float playback_rate = 1;  ///< clip seconds a second
  float blend_s = 0;        ///< length of the blend into the clip, at most the way to the peak
  float peak_s = 0;         ///< when the clip's peak is reached
  float end_s = 0;          ///< when the clip's annotated end is reached; the way back follows
  float return_s = 0;       ///< length of the way back
  float yaw = 0;            ///< turn that aligns the clip, radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< that aligns it, after the turn, m
  Eigen::Vector3f travel = Eigen::Vector3f::Zero();  ///< of the idle after the response, level, m
  motion::Side support = motion::Side::left;
  motion::PerSide<FootPlan> feet;
  std::array<WeightShift, 3> shifts;  ///< the clip's first step and at most two on the way back
  motion::Signs arcs_in{};            ///< of the blend into the clip when it begins
  motion::Signs arcs_back{};          ///< of the blend back to idle when it begins
};

inline constexpr float kMostPlaybackRate = 1.4F;
/// The shortest blend into a clip, and the way back where no foot has to step, s.
inline constexpr float kBlend = 0.2F;

/// Plans the response of a character in `state` with clip number `clip`, which must be annotated or
/// the library's idle clip, to an impact predicted in `time_to_impact_s` (positive, finite). Input
/// that cannot be used (no such clip, no annotation, times out of order, no poses, a state that is
/// not finite) gives an invalid response. Allocates nothing, throws nothing.
Response make_response(const PreparedLibrary& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s, const Origin& origin = {}) noexcept;

/// Whether make_response could use its input.
bool is_valid(const Response& response) noexcept;

/// The pose `time_s` after perception, world. Any time from 0 on, continuous over it; a time that
/// is negative or not finite is taken as 0. Of an invalid response, the pose of no motion at the
/// world's origin. Costs a few microseconds; allocates nothing, throws nothing.
motion::Pose pose_at(const Response& response, float time_s) noexcept;

/// When the way back to idle is over, s from perception; 0 for the idle clip of an idling
/// character.
float duration_s(const Response& response) noexcept;

}  // namespace flinch::runtime
