// SPDX-License-Identifier: MIT
#include "runtime/response.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation.h"

namespace flinch::runtime {
namespace {

const motion::Clip& clip_of(const Response& response) {
  return response.library->clips[static_cast<std::size_t>(response.clip)];
}

const motion::Motion& idle_of(const Response& response) {
  return response.library->clips[static_cast<std::size_t>(response.library->idle)].motion;
}

bool is_idle(const Response& response) {
  return response.clip == response.library->idle;
}

bool is_finite(const features::CharacterState& state) {
  return std::isfinite(state.idle_time_s) && state.position.allFinite() &&
         std::isfinite(state.facing);
}

bool has_clip(const database::Library& library, int clip) {
  return clip >= 0 && static_cast<std::size_t>(clip) < library.clips.size() &&
         !library.clips[static_cast<std::size_t>(clip)].motion.poses.empty();
}

bool is_in_order(const motion::Annotation& annotation) {
  return annotation.onset_s >= 0 && annotation.onset_s < annotation.peak_s &&
         annotation.peak_s <= annotation.end_s && std::isfinite(annotation.end_s);
}

bool can_use(const database::Library& library, const features::CharacterState& state, int clip,
             float time_to_impact_s) {
  if (!has_clip(library, library.idle) || !has_clip(library, clip)) return false;
  if (!is_finite(state) || !(time_to_impact_s > 0) || !std::isfinite(time_to_impact_s)) {
    return false;
  }
  const auto& annotation = library.clips[static_cast<std::size_t>(clip)].annotation;
  return clip == library.idle || (annotation && is_in_order(*annotation));
}

motion::Pose idle_pose_at(const Response& response, float time_s) {
  return features::idle_pose(idle_of(response), response.state, time_s);
}

motion::Pose idle_pose_after_clip_at(const Response& response, float time_s) {
  motion::Pose pose = idle_pose_at(response, time_s);
  pose.root_position += response.travel;
  return pose;
}

// The clip's pose, aligned: clip time is onset + rate (t - begin).
motion::Pose clip_pose_at(const Response& response, float time_s) {
  const motion::Clip& clip = clip_of(response);
  const float clip_time_s =
      clip.annotation->onset_s + response.playback_rate * (time_s - response.begin_s);
  return motion::placed(motion::sample(clip.motion, clip_time_s), response.yaw,
                        response.translation);
}

Eigen::Vector3f level(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), 0};
}

}  // namespace

Response make_response(const database::Library& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s) noexcept {
  Response response;
  if (!can_use(library, state, clip, time_to_impact_s)) return response;
  response.library = &library;
  response.clip = clip;
  response.state = state;
  if (is_idle(response)) return response;

  // With d from onset to peak: rate = clamp(d / T, 1, most), begin = max(0, T - d / rate).
  const motion::Annotation& annotation = *clip_of(response).annotation;
  const float onset_to_peak_s = annotation.peak_s - annotation.onset_s;
  response.playback_rate = std::clamp(onset_to_peak_s / time_to_impact_s, 1.0F, kMostPlaybackRate);
  const float way_to_peak_s = onset_to_peak_s / response.playback_rate;
  response.begin_s = std::max(0.0F, time_to_impact_s - way_to_peak_s);
  response.blend_s = std::min(kBlend, way_to_peak_s);
  response.end_s =
      response.begin_s + (annotation.end_s - annotation.onset_s) / response.playback_rate;

  response.yaw = state.facing;
  response.translation = level(idle_pose_at(response, response.begin_s).root_position -
                               clip_pose_at(response, response.begin_s).root_position);
  const float over_s = duration_s(response);
  response.travel = level(clip_pose_at(response, over_s).root_position -
                          idle_pose_at(response, over_s).root_position);
  return response;
}

bool is_valid(const Response& response) noexcept {
  return response.library != nullptr;
}

motion::Pose pose_at(const Response& response, float time_s) noexcept {
  if (!is_valid(response)) return {};
  const float t = std::isfinite(time_s) ? std::max(time_s, 0.0F) : 0.0F;
  const Response& r = response;
  if (is_idle(r) || t <= r.begin_s) return idle_pose_at(r, t);
  if (t >= duration_s(r)) return idle_pose_after_clip_at(r, t);
  if (t < r.begin_s + r.blend_s) {
    const float weight = motion::ease_in_ease_out((t - r.begin_s) / r.blend_s);
    return motion::blend_on_first_arc(idle_pose_at(r, t), clip_pose_at(r, t), weight,
                                      idle_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s));
  }
  if (t <= r.end_s) return clip_pose_at(r, t);
  const float weight = motion::ease_in_ease_out((t - r.end_s) / kBlend);
  return motion::blend_on_first_arc(clip_pose_at(r, t), idle_pose_after_clip_at(r, t), weight,
                                    clip_pose_at(r, r.end_s), idle_pose_after_clip_at(r, r.end_s));
}

float duration_s(const Response& response) noexcept {
  if (!is_valid(response) || is_idle(response)) return 0;
  return response.end_s + kBlend;
}

}  // namespace flinch::runtime
