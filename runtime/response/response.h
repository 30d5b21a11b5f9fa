// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "motion/interpolation.h"
#include "runtime/response/inertialization.h"

namespace flinch::runtime {

struct PreparedLibrary;  // opaque: runtime::Library::prepared()

/// An interval of time, s after perception. The default never begins.
struct Interval {
  float begin_s = std::numeric_limits<float>::infinity();
  float end_s = std::numeric_limits<float>::infinity();
};

/// How one foot of a response differs from the foot of its clip, so that it starts from where it
/// stands.
struct FootPlan {
  motion::PlanarMove offset;    ///< added to the clip's foot until `correction` begins
  Interval correction;          ///< `offset` fades to none, in a swing of the clip or an extra step
  float correction_lift_m = 0;  ///< height of that extra step; 0 in a swing of the clip
  Interval return_step;         ///< the step back to where the idle clip has the foot
  float return_lift_m = 0;      ///< height of that step
  /// Height (m) and tilt of the foot against the clip's, beside `offset`, when the clip begins; the
  /// blend into the clip removes them. The foot rolls over `pivot`, in its own frame, m: the ball
  /// of a foot whose heel is up, the heel of one whose toes are.
  Eigen::Vector3f pivot = Eigen::Vector3f::Zero();
  Eigen::Vector3f rise = Eigen::Vector3f::Zero();
  Eigen::Quaternionf tilt = Eigen::Quaternionf::Identity();
};

/// How a foot that swings when a walk is left comes down: this is added to where it will stand, and
/// fades out.
struct Landing {
  Interval interval;                                   ///< by default never
  Eigen::Vector3f way = Eigen::Vector3f::Zero();       ///< to where it swings, at the begin, m
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();  ///< of the swing, at the begin, m/s
  /// Turn from the orientation in which it will stand to that of the swing, at the begin.
  Eigen::Quaternionf tilt = Eigen::Quaternionf::Identity();
};

/// A shift of the weight onto one foot, so that the other can leave the ground.
struct WeightShift {
  Interval interval;  ///< the whole shift: there, held, and back
  Interval hold;      ///< the centre of mass is above the sole of the support foot
  /// How far the pelvis moves for that, world, m.
  Eigen::Vector3f pelvis = Eigen::Vector3f::Zero();
};

/// Key poses of a response by rule (make_brace), world.
struct Brace {
  float startle_s = 0;  ///< duration of the startle; 0: none
  motion::Pose startled;
  motion::Pose sustained;  ///< reached at the response's peak
};

/// The plan of a motion that answers a scenario with a clip. Training and games make it with this
/// same code. A plain value that refers to the library it was made from, which must outlive it.
/// docs/response.md gives the reasons.
///
/// The character goes on in its stance (or settles, see Inertialization) until `begin_s`; a walking
/// one comes to rest from `leave_s` on. Then the clip plays from
/// its onset at `playback_rate`, and blends in along a minimum-jerk curve over `blend_duration_s`
/// while it plays. The clip's peak falls on the predicted impact; a clip too long for that plays
/// faster, up to kMaxPlaybackRate, and may peak late. From the clip's annotated end the character
/// blends back to idle over `return_duration_s`, while the clip plays on and holds its last pose.
///
/// Alignment (Zordan et al. 2007, section 6). Clips are stored facing +X: the response turns the
/// clip to the character's facing and moves it so that the support foot, which carries more weight
/// in the clip's opening, is where the character has it. Feet on the ground stay. Where the clip
/// has a foot elsewhere, the foot goes there in the clip's next swing of that foot or, from far, in
/// a small extra step. The weight shifts over the support foot before the other foot leaves the
/// ground.
///
/// The way back. Where the clip took a step, the idle clip continues at the new place: the
/// character's next state is `state` with `idle_displacement` added to its position. A turn is not
/// kept: the character faces as before, and its feet step back into place. A walking character
/// walks on from there: its walk begins anew at the moment in which the free foot passes the
/// standing one, from a standstill to its full speed in kWalkOn_s.
struct Response {
  const PreparedLibrary* library = nullptr;  ///< null: invalid
  int clip = 0;                    ///< index in the library; its idle clip means to do nothing
  Brace brace;                     ///< in place of the clip where `clip` is kNoClip
  features::CharacterState state;  ///< of the character at perception
  /// Until when it goes on in a stance that travels; 0 for others, s after perception.
  float leave_s = 0;
  features::CharacterState rest;      ///< in which it comes to rest, at leave_s
  Inertialization inertialization;    ///< by which the character differed from that then
  motion::PerSide<Landing> landings;  ///< of feet that swing at leave_s
  float first_motion_s = 0;  ///< when the response first differs from going on, s after perception
  float begin_s = 0;         ///< when the clip begins, s after perception
  float playback_rate = 1;   ///< seconds of the clip per second
  float blend_duration_s = 0;   ///< of the blend into the clip; ends by the clip's peak
  float peak_s = 0;             ///< when the clip's peak is reached, s after perception
  float end_s = 0;              ///< when the way back begins: the clip's annotated end
  float return_duration_s = 0;  ///< of the way back to idle, s
  float yaw = 0;                ///< turn that aligns the clip, radians
  Eigen::Vector3f translation =
      Eigen::Vector3f::Zero();  ///< shift that aligns it after the turn, m
  /// Of the character after the response, at perception and without `idle_displacement`; where it
  /// walks on, at walk_on_s.
  features::CharacterState home;
  float walk_on_s = -1;  ///< when its walk begins anew, s after perception; negative: it has none
  /// From the stance before the response to that after it, horizontal, m.
  Eigen::Vector3f idle_displacement = Eigen::Vector3f::Zero();
  motion::Side support = motion::Side::left;  ///< the foot on which the clip is laid
  bool goes_on_over_support = false;          ///< a walker leaves its walk toward that foot
  motion::PerSide<FootPlan> feet;
  std::array<WeightShift, 3> shifts;  ///< for the clip's first step and at most two on the way back
  motion::Signs arcs_in{};            ///< signs of the blend into the clip, fixed when it begins
  motion::Signs arcs_back{};          ///< signs of the blend back to idle, fixed when it begins
};

/// In place of a clip's index: the response is by rule.
inline constexpr int kNoClip = -1;

/// The fastest playback of a clip, seconds of the clip per second.
inline constexpr float kMaxPlaybackRate = 1.4F;
/// The shortest blend into a clip, and the shortest way back where no foot steps, s.
inline constexpr float kMinBlend_s = 0.2F;
/// From a standstill to the full speed of a walk, s.
inline constexpr float kWalkOn_s = 0.5F;

/// Plans the response of a character in `state` with clip number `clip`, which is annotated or the
/// library's idle clip, to an impact in `time_to_impact_s` (positive, finite). Input that cannot be
/// used (no such clip, no annotation, a clip without poses or with times out of order, a state that
/// is not finite) gives an invalid response. Costs tens of microseconds; allocates nothing, throws
/// nothing.
Response make_response(const PreparedLibrary& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s,
                       const Inertialization& inertialization = {}) noexcept;

/// Whether the input of make_response() could be used.
bool is_valid(const Response& response) noexcept;

/// Whether a valid response does nothing: its clip is the idle clip.
bool is_idle(const Response& response) noexcept;

/// The pose `time_s` after perception, world; continuous in time. A time that is negative or not
/// finite counts as 0. An invalid response gives the rest pose at the world's origin. Costs one or
/// two microseconds; allocates nothing, throws nothing.
motion::Pose pose_at(const Response& response, float time_s) noexcept;

/// The time that has passed for the character's stance after the response, in `home`: that since
/// perception or, where it walks on, that of the walk.
float home_time_s(const Response& response, float time_s) noexcept;

/// When the way back to idle is over, s after perception; 0 for the idle clip of an idling
/// character.
float duration_s(const Response& response) noexcept;

}  // namespace flinch::runtime
