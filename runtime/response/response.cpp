// SPDX-License-Identifier: MIT
#include "runtime/response/response.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;

/// All that the feet hang from.
constexpr std::array kLegRoles{Role::pelvis,    Role::left_thigh,  Role::left_shin,
                               Role::left_foot, Role::right_thigh, Role::right_shin,
                               Role::right_foot};

bool is_idle(const Response& response) {
  return response.clip == response.library->library->idle;
}

float fraction_of(const Interval& interval, float time_s) {
  if (time_s <= interval.begin_s) return 0;
  if (time_s >= interval.end_s) return 1;
  return (time_s - interval.begin_s) / (interval.end_s - interval.begin_s);
}

// A step over part u of its window: 64 u^3 (1 - u)^3 leaves and meets the ground without a jolt,
// and the foot is lifted before it travels and has arrived before it is put down.
FootPose step_between(const FootPose& from, const FootPose& to, float u, float lift_m) {
  constexpr float kLiftShare = 0.1F;
  const float weight = motion::minimum_jerk((u - kLiftShare) / (1 - 2 * kLiftShare));
  FootPose place = blend(from, to, weight);
  place.ankle.z() += lift_m * 64 * u * u * u * (1 - u) * (1 - u) * (1 - u);
  return place;
}

// A foot that goes its clip's way from where it was, not where the clip had it, which differ in
// height and tilt alone: what differs is taken back by weight. Blending the places themselves would
// drag a foot over the ground that the clip lifts.
FootPose continuous_foot(const FootPose& from, const FootPose& clip_from, const FootPose& clip_now,
                         float weight) {
  const Eigen::Quaternionf tilt = from.orientation * clip_from.orientation.conjugate();
  return {clip_now.ankle + (1 - weight) * (from.ankle - clip_from.ankle),
          motion::slerp(tilt, Eigen::Quaternionf::Identity(), weight) * clip_now.orientation};
}

FootPose moved(const FootPose& place, const PlanarTransform& move) {
  const Eigen::Quaternionf turn = motion::rotation_about(Eigen::Vector3f::UnitZ(), move.yaw);
  return {turn * place.ankle + move.translation, turn * place.orientation};
}

float blend_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.begin_s) / r.blend_duration_s);
}

float return_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.end_s) / r.return_duration_s);
}

// Every joint by itself.
Pose blended_joints_at(const Response& r, float t) {
  if (is_idle(r))
    return motion::blend(source_pose_at(r, t), return_pose_at(r, t), return_weight(r, t));
  if (t <= r.begin_s) return source_pose_at(r, t);
  if (t < r.begin_s + r.blend_duration_s) {
    return motion::blend_along_initial_arc(source_pose_at(r, t), clip_pose_at(r, t),
                                           blend_weight(r, t), source_pose_at(r, r.begin_s),
                                           clip_pose_at(r, r.begin_s));
  }
  if (t <= r.end_s) return clip_pose_at(r, t);
  return motion::blend_along_initial_arc(clip_pose_at(r, t), return_pose_at(r, t),
                                         return_weight(r, t), clip_pose_at(r, r.end_s),
                                         return_pose_at(r, r.end_s));
}

// Where clip and source differ much, a foot on its way from one to the other may dip.
FootPose above_ground(const Response& r, Side side, FootPose place,
                      const Eigen::Quaternionf& toes) {
  constexpr float kMaxDepth_m = -0.001F;  // m
  const float lowest = min_height(r.library->soles[motion::index_of(side)], place, toes,
                                  r.library->skeleton().offset[motion::roles_of(side).toes]);
  place.ankle.z() += std::max(kMaxDepth_m - lowest, 0.0F);
  return place;
}

FootPose foot_at(const Response& r, Side side, float t) {
  const FootPlan& plan = r.feet[motion::index_of(side)];
  if (!is_idle(r) && t <= r.begin_s) return source_foot_at(r, side, t);
  if (!is_idle(r) && t < r.begin_s + r.blend_duration_s) {
    return continuous_foot(source_foot_at(r, side, r.begin_s), clip_foot_at(r, side, r.begin_s),
                           clip_foot_at(r, side, t), blend_weight(r, t));
  }
  const FootPose away = is_idle(r) ? source_foot_at(r, side, t) : clip_foot_at(r, side, t);
  if (t <= plan.return_step.begin_s) return away;
  const float u = fraction_of(plan.return_step, t);
  if (plan.return_lift_m > 0)
    return step_between(away, return_foot_at(r, side, t), u, plan.return_lift_m);
  return blend(away, return_foot_at(r, side, t), motion::minimum_jerk(u));
}

Eigen::Vector3f weight_shift_at(const Response& r, float t) {
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  for (const WeightShift& part : r.shifts) {
    const Interval up{part.interval.begin_s, part.hold.begin_s};
    const Interval down{part.hold.end_s, part.interval.end_s};
    const float weight =
        motion::minimum_jerk(fraction_of(up, t)) - motion::minimum_jerk(fraction_of(down, t));
    if (weight > 0) shift += weight * part.pelvis;
  }
  return shift;
}

// Whether the clip plays as it is, feet and all.
bool is_unmodified_clip(const Response& r, float t) {
  if (is_idle(r) || t < r.begin_s + r.blend_duration_s || t > r.end_s) return false;
  for (const FootPlan& plan : r.feet) {
    const bool is_offset = plan.offset.yaw != 0 || !plan.offset.translation.isZero(0);
    if (is_offset && t < plan.correction.end_s) return false;
  }
  return true;
}

// By how much the pelvis must come down for both legs to reach their feet, m: 0 or below. Legs may
// be as straight as the motion has them, and otherwise keep a little bend.
float pelvis_drop(const motion::Skeleton& skeleton, const JointFrames& frames,
                  const Eigen::Vector3f& shift, const motion::PerSide<FootPose>& feet) {
  constexpr float kMaxExtension = 0.98F;
  constexpr float kMinPelvisDrop_m = -0.15F;  // m: a foot too far away is left behind rather
  float drop = 0;
  for (Side side : motion::kSides) {
    const motion::LimbRoles leg = motion::roles_of(motion::leg_of(side));
    const float length = motion::limb_length(skeleton, motion::leg_of(side));
    const float now = (frames.position[leg.end] - frames.position[leg.upper]).norm();
    const float reach = std::max(kMaxExtension * length, now);
    const Eigen::Vector3f hip = frames.position[leg.upper] + shift;
    const float highest = motion::max_upper_height(hip, feet[motion::index_of(side)].ankle, reach);
    drop = std::min(drop, highest - hip.z());
  }
  return std::max(drop, kMinPelvisDrop_m);
}

}  // namespace

Eigen::Vector3f horizontal(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), 0};
}

Pose source_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  return inertialized_pose(*r.library, r.state, r.inertialization, time_s, roles);
}

Pose return_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  Pose pose = features::idle_pose(r.library->idle(), r.state, time_s, roles);
  pose.root_position += r.idle_displacement;
  return pose;
}

// Clip time is onset + rate (t - begin).
Pose clip_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  const motion::Clip& clip = r.library->clip(r.clip);
  const float clip_time_s = clip.annotation->onset_s + r.playback_rate * (time_s - r.begin_s);
  return motion::placed(motion::sample(clip.motion, clip_time_s, roles), r.yaw, r.translation);
}

FootPose source_foot_at(const Response& r, Side side, float time_s) {
  const std::size_t i = motion::index_of(side);
  if (!r.inertialization.is_zero && r.inertialization.stands[i]) return r.inertialization.foot[i];
  return foot_of(r.library->skeleton(), source_pose_at(r, time_s, leg_chain(side)), side);
}

FootPose return_foot_at(const Response& r, Side side, float time_s) {
  return foot_of(r.library->skeleton(), return_pose_at(r, time_s, leg_chain(side)), side);
}

FootPose uncorrected_clip_foot_at(const Response& r, Side side, float time_s) {
  return foot_of(r.library->skeleton(), clip_pose_at(r, time_s, leg_chain(side)), side);
}

FootPose clip_foot_at(const Response& r, Side side, float time_s) {
  const FootPlan& plan = r.feet[motion::index_of(side)];
  const FootPose own = uncorrected_clip_foot_at(r, side, time_s);
  const float u = fraction_of(plan.correction, time_s);
  if (u >= 1) return own;
  const FootPose offset = moved(own, plan.offset);
  if (u <= 0) return offset;
  if (plan.correction_lift_m > 0) return step_between(offset, own, u, plan.correction_lift_m);
  return blend(offset, own, motion::minimum_jerk(u));
}

Pose pose_at(const Response& response, float time_s) noexcept {
  if (!is_valid(response)) return {};
  const Response& r = response;
  const float t = std::isfinite(time_s) ? std::max(time_s, 0.0F) : 0.0F;
  if (t <= r.first_motion_s && r.inertialization.is_zero) return source_pose_at(r, t);
  if (t >= duration_s(r)) return return_pose_at(r, t);
  Pose pose = blended_joints_at(r, t);
  const Eigen::Vector3f shift = weight_shift_at(r, t);
  if (shift.isZero(0) && is_unmodified_clip(r, t)) return pose;

  const motion::Skeleton& skeleton = r.library->skeleton();
  JointFrames frames = motion::forward_kinematics(skeleton, pose, kLegRoles);
  motion::PerSide<FootPose> feet;
  for (Side side : motion::kSides) {
    feet[motion::index_of(side)] =
        above_ground(r, side, foot_at(r, side, t), pose.rotation[motion::roles_of(side).toes]);
  }
  const Eigen::Vector3f move =
      shift + pelvis_drop(skeleton, frames, shift, feet) * Eigen::Vector3f::UnitZ();
  pose.root_position += move;
  for (Role role : kLegRoles) frames.position[role] += move;
  for (Side side : motion::kSides) {
    const FootPose& foot = feet[motion::index_of(side)];
    motion::move_limb_end(frames, motion::leg_of(side), foot.ankle, foot.orientation, pose);
  }
  return pose;
}

bool is_valid(const Response& response) noexcept {
  return response.library != nullptr;
}

float duration_s(const Response& response) noexcept {
  if (!is_valid(response)) return 0;
  return response.end_s + response.return_duration_s;
}

}  // namespace flinch::runtime
