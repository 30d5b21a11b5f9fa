// SPDX-License-Identifier: MIT
#include "runtime/response/response_plan.h"

#include <algorithm>
#include <cmath>

#include "runtime/response/blend_duration.h"
#include "runtime/response/foot_plan.h"
#include "runtime/response/leaving_plan.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"
#include "runtime/response/return_plan.h"
#include "runtime/response/weight_shift.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

constexpr float kShiftDuration_s = 0.3F;  // of a weight shift where there is time

bool is_finite(const features::CharacterState& state) {
  return std::isfinite(state.idle_time_s) && state.position.allFinite() &&
         std::isfinite(state.facing);
}

bool is_finite(const Inertialization& inertialization) {
  if (inertialization.is_zero) return true;
  bool finite = inertialization.root.allFinite() && inertialization.root_velocity.allFinite();
  for (motion::Role role : motion::kRoles) {
    finite = finite && inertialization.rotation[role].allFinite() &&
             inertialization.rotation_velocity[role].allFinite() &&
             std::isfinite(inertialization.stiffening[role]);
  }
  for (const FootPose& foot : inertialization.foot) {
    finite = finite && foot.ankle.allFinite() && foot.orientation.coeffs().allFinite();
  }
  return finite;
}

bool has_clip(const database::ClipLibrary& library, int clip) {
  return clip >= 0 && static_cast<std::size_t>(clip) < library.clips.size() &&
         !library.clip(clip).motion.poses.empty();
}

bool is_in_order(const motion::Annotation& annotation) {
  return annotation.onset_s >= 0 && annotation.onset_s < annotation.peak_s &&
         annotation.peak_s <= annotation.end_s && std::isfinite(annotation.end_s);
}

bool is_usable_input(const PreparedLibrary& prepared, const features::CharacterState& state,
                     int clip, float time_to_impact_s, const Inertialization& inertialization) {
  if (!is_usable_start(prepared, state, time_to_impact_s, inertialization)) return false;
  const database::ClipLibrary& library = *prepared.library;
  if (!has_clip(library, clip)) return false;
  const auto& annotation = library.clip(clip).annotation;
  return clip == library.idle || (annotation && is_in_order(*annotation));
}

// With d from onset to peak and b the earliest begin: rate = clamp(d / (T - b), 1, maximum) and
// begin = max(b, T - d / rate).
void set_timing(const motion::Annotation& annotation, float time_to_impact_s, float earliest_s,
                Response& r) {
  const float onset_to_peak_s = annotation.peak_s - annotation.onset_s;
  const float left_s = time_to_impact_s - earliest_s;
  r.playback_rate =
      left_s > 0 ? std::clamp(onset_to_peak_s / left_s, 1.0F, kMaxPlaybackRate) : kMaxPlaybackRate;
  const float time_to_peak_s = onset_to_peak_s / r.playback_rate;
  r.begin_s = std::max(earliest_s, time_to_impact_s - time_to_peak_s);
  r.blend_duration_s = std::min(kMinBlend_s, time_to_peak_s);
  r.peak_s = r.begin_s + time_to_peak_s;
  r.end_s = r.begin_s + (annotation.end_s - annotation.onset_s) / r.playback_rate;
}

// Lays the clip's support foot on the character's.
Start align(Response& r) {
  r.yaw = r.rest.facing;
  r.translation = Eigen::Vector3f::Zero();
  Start start{source_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s)};
  r.translation = horizontal(source_foot_in(r, r.support, start.source).ankle -
                             foot_of(r.library->skeleton(), start.clip, r.support).ankle);
  start.clip.root_position += r.translation;
  land_beside(r, start);
  return start;
}

// When the clip plays, where it is laid, and how the feet come to it.
void place_clip(const motion::Annotation& annotation, float time_to_impact_s, float earliest_s,
                Response& r) {
  set_timing(annotation, time_to_impact_s, earliest_s, r);
  const Start start = align(r);
  for (Side side : motion::kSides) plan_foot(r, side, start);
  r.arcs_in = motion::shorter_arcs(start.source, start.clip);
  r.shifts[0] = {};
}

// Shifts the weight before the first step of a clip that has been placed. The momentum of a walk
// takes it over the foot in front; a shift would hurry it.
void plan_first_shift(Response& r) {
  const std::optional<float> lift_s = first_lift_s(r);
  if (!lift_s || r.goes_on_over_support) return;
  shift_weight(r, 0, r.support, *lift_s, std::max(*lift_s - kShiftDuration_s, r.leave_s), r.end_s);
}

// The blend into a clip that has been placed. It takes most of a plan's time.
void plan_blend(Response& r) {
  choose_blend_duration(r);
  const std::optional<float> lift_s = first_lift_s(r);
  const bool is_lifted_meanwhile = lift_s && *lift_s < r.begin_s + r.blend_duration_s;
  if (is_lifted_meanwhile) plan_first_shift(r);
}

// When a clip that has been placed must begin if its first step has too little time: the weight has
// to shift before, or the support foot to land.
std::optional<float> later_begin_s(const Response& r) {
  const std::optional<float> lift_s = first_lift_s(r);
  const float ready_s = ready_to_lift_s(r);
  if (!lift_s || *lift_s >= ready_s) return std::nullopt;
  return ready_s - (*lift_s - r.begin_s) * r.playback_rate / kMaxPlaybackRate;
}

// A walker needs time to land whether it shifts its weight or not, others only if they shift it.
void plan_clip(const motion::Annotation& annotation, float time_to_impact_s, bool walked,
               Response& r) {
  place_clip(annotation, time_to_impact_s, r.leave_s, r);
  const std::optional<float> later_s = later_begin_s(r);
  if (!later_s || !walked) plan_first_shift(r);
  if (later_s && (walked || !r.shifts[0].pelvis.isZero(0))) {
    place_clip(annotation, time_to_impact_s, *later_s, r);
    plan_first_shift(r);
  }
  plan_blend(r);
}

}  // namespace

bool is_usable_start(const PreparedLibrary& prepared, const features::CharacterState& state,
                     float time_to_impact_s, const Inertialization& inertialization) {
  return prepared.library != nullptr && has_clip(*prepared.library, prepared.library->idle) &&
         is_finite(state) && is_finite(inertialization) && prepared.has_stance(state.stance) &&
         time_to_impact_s > 0 && std::isfinite(time_to_impact_s);
}

Response make_response(const PreparedLibrary& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s,
                       const Inertialization& inertialization) noexcept {
  Response r;
  if (!is_usable_input(library, state, clip, time_to_impact_s, inertialization)) return r;
  r.library = &library;
  r.clip = clip;
  r.state = state;
  r.rest = state;
  r.home = state;
  r.inertialization = inertialization;
  r.support = footwork_of(r).support;
  if (clip == library.library->idle) {
    if (!inertialization.is_zero) plan_return(r);
    return r;
  }
  const motion::Annotation& annotation = *library.clip(clip).annotation;
  const bool walked = walks(library, state, inertialization);
  if (walked) {
    set_timing(annotation, time_to_impact_s, 0, r);
    plan_leaving(r);
  }
  plan_clip(annotation, time_to_impact_s, walked, r);
  r.home = walked ? features::later(library.stance_of(state).loop, state, r.leave_s) : state;
  plan_return(r);
  r.first_motion_s = walked ? r.leave_s : std::min(r.begin_s, r.shifts[0].interval.begin_s);
  return r;
}

}  // namespace flinch::runtime
