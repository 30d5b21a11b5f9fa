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

using motion::FootPlace;
using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;

/// All that the feet hang from.
constexpr std::array kLegs{Role::pelvis,      Role::left_thigh, Role::left_shin, Role::left_foot,
                           Role::right_thigh, Role::right_shin, Role::right_foot};

bool is_idle(const Response& response) {
  return response.clip == response.library->library->idle;
}

float part_of(const Window& window, float time_s) {
  if (time_s <= window.begin_s) return 0;
  if (time_s >= window.end_s) return 1;
  return (time_s - window.begin_s) / (window.end_s - window.begin_s);
}

// A step over part u of its window: 64 u^3 (1 - u)^3 leaves and meets the ground without a jolt,
// and the foot is lifted before it travels and has arrived before it is put down.
FootPlace step_between(const FootPlace& from, const FootPlace& to, float u, float lift_m) {
  constexpr float kOnlyLift = 0.1F;
  const float weight = motion::minimum_jerk((u - kOnlyLift) / (1 - 2 * kOnlyLift));
  FootPlace place = blend(from, to, weight);
  place.ankle.z() += lift_m * 64 * u * u * u * (1 - u) * (1 - u) * (1 - u);
  return place;
}

// A foot that goes its clip's way from where it was, not where the clip had it, which differ in
// height and tilt alone: what differs is taken back by weight. Blending the places themselves would
// drag a foot over the ground that the clip lifts.
FootPlace without_jump(const FootPlace& from, const FootPlace& clip_from, const FootPlace& clip_now,
                       float weight) {
  const Eigen::Quaternionf tilt = from.orientation * clip_from.orientation.conjugate();
  return {clip_now.ankle + (1 - weight) * (from.ankle - clip_from.ankle),
          motion::slerp(tilt, Eigen::Quaternionf::Identity(), weight) * clip_now.orientation};
}

FootPlace moved(const FootPlace& place, const GroundMove& move) {
  const Eigen::Quaternionf turn = motion::turn_about(Eigen::Vector3f::UnitZ(), move.yaw);
  return {turn * place.ankle + move.translation, turn * place.orientation};
}

float blend_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.begin_s) / r.blend_s);
}

float return_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.end_s) / r.return_s);
}

// Every joint by itself.
Pose body_at(const Response& r, float t) {
  if (is_idle(r))
    return motion::blend(source_pose_at(r, t), home_pose_at(r, t), return_weight(r, t));
  if (t <= r.begin_s) return source_pose_at(r, t);
  if (t < r.begin_s + r.blend_s) {
    return motion::blend_on_first_arc(source_pose_at(r, t), clip_pose_at(r, t), blend_weight(r, t),
                                      source_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s));
  }
  if (t <= r.end_s) return clip_pose_at(r, t);
  return motion::blend_on_first_arc(clip_pose_at(r, t), home_pose_at(r, t), return_weight(r, t),
                                    clip_pose_at(r, r.end_s), home_pose_at(r, r.end_s));
}

// Where clip and source differ much, a foot on its way from one to the other may dip.
FootPlace above_ground(const Response& r, Side side, FootPlace place,
                       const Eigen::Quaternionf& toes) {
  constexpr float kUnder = -0.001F;  // m
  const float lowest = lowest_point(r.library->soles[motion::index_of(side)], place, toes,
                                    r.library->skeleton().offset[motion::roles_of(side).toes]);
  place.ankle.z() += std::max(kUnder - lowest, 0.0F);
  return place;
}

FootPlace foot_at(const Response& r, Side side, float t) {
  const FootPlan& plan = r.feet[motion::index_of(side)];
  if (!is_idle(r) && t <= r.begin_s) return source_foot_at(r, side, t);
  if (!is_idle(r) && t < r.begin_s + r.blend_s) {
    return without_jump(source_foot_at(r, side, r.begin_s), clip_foot_at(r, side, r.begin_s),
                        clip_foot_at(r, side, t), blend_weight(r, t));
  }
  const FootPlace away = is_idle(r) ? source_foot_at(r, side, t) : clip_foot_at(r, side, t);
  if (t <= plan.home.begin_s) return away;
  const float u = part_of(plan.home, t);
  if (plan.home_lift_m > 0)
    return step_between(away, home_foot_at(r, side, t), u, plan.home_lift_m);
  return blend(away, home_foot_at(r, side, t), motion::minimum_jerk(u));
}

Eigen::Vector3f weight_shift_at(const Response& r, float t) {
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  for (const WeightShift& part : r.shifts) {
    const Window up{part.window.begin_s, part.held.begin_s};
    const Window down{part.held.end_s, part.window.end_s};
    const float weight =
        motion::minimum_jerk(part_of(up, t)) - motion::minimum_jerk(part_of(down, t));
    if (weight > 0) shift += weight * part.pelvis;
  }
  return shift;
}

// Whether the clip plays as it is, feet and all.
bool is_untouched_clip(const Response& r, float t) {
  if (is_idle(r) || t < r.begin_s + r.blend_s || t > r.end_s) return false;
  for (const FootPlan& plan : r.feet) {
    const bool is_offset = plan.offset.yaw != 0 || !plan.offset.translation.isZero(0);
    if (is_offset && t < plan.change.end_s) return false;
  }
  return true;
}

// By how much the pelvis must come down for both legs to reach their feet, m: 0 or below. Legs may
// be as straight as the motion has them, and otherwise keep a little bend.
float way_down(const motion::Skeleton& skeleton, const JointFrames& frames,
               const Eigen::Vector3f& shift, const motion::PerSide<FootPlace>& feet) {
  constexpr float kBent = 0.98F;
  constexpr float kLowest = -0.15F;  // m: a foot too far away is left behind rather
  float down = 0;
  for (Side side : motion::kSides) {
    const motion::LimbRoles leg = motion::roles_of(motion::leg_of(side));
    const float length = motion::limb_length(skeleton, motion::leg_of(side));
    const float now = (frames.position[leg.end] - frames.position[leg.upper]).norm();
    const float reach = std::max(kBent * length, now);
    const Eigen::Vector3f hip = frames.position[leg.upper] + shift;
    const float highest = motion::highest_upper(hip, feet[motion::index_of(side)].ankle, reach);
    down = std::min(down, highest - hip.z());
  }
  return std::max(down, kLowest);
}

}  // namespace

Eigen::Vector3f level(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), 0};
}

Pose source_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  return pose_from(*r.library, r.state, r.origin, time_s, roles);
}

Pose home_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  Pose pose = features::idle_pose(r.library->idle(), r.state, time_s, roles);
  pose.root_position += r.travel;
  return pose;
}

// Clip time is onset + rate (t - begin).
Pose clip_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  const motion::Clip& clip = r.library->clip(r.clip);
  const float clip_time_s = clip.annotation->onset_s + r.playback_rate * (time_s - r.begin_s);
  return motion::placed(motion::sample(clip.motion, clip_time_s, roles), r.yaw, r.translation);
}

FootPlace source_foot_at(const Response& r, Side side, float time_s) {
  const std::size_t i = motion::index_of(side);
  if (!r.origin.idles && r.origin.stands[i]) return r.origin.foot[i];
  return foot_of(r.library->skeleton(), source_pose_at(r, time_s, roles_to_foot(side)), side);
}

FootPlace home_foot_at(const Response& r, Side side, float time_s) {
  return foot_of(r.library->skeleton(), home_pose_at(r, time_s, roles_to_foot(side)), side);
}

FootPlace uncorrected_clip_foot_at(const Response& r, Side side, float time_s) {
  return foot_of(r.library->skeleton(), clip_pose_at(r, time_s, roles_to_foot(side)), side);
}

FootPlace clip_foot_at(const Response& r, Side side, float time_s) {
  const FootPlan& plan = r.feet[motion::index_of(side)];
  const FootPlace own = uncorrected_clip_foot_at(r, side, time_s);
  const float u = part_of(plan.change, time_s);
  if (u >= 1) return own;
  const FootPlace offset = moved(own, plan.offset);
  if (u <= 0) return offset;
  if (plan.change_lift_m > 0) return step_between(offset, own, u, plan.change_lift_m);
  return blend(offset, own, motion::minimum_jerk(u));
}

Pose pose_at(const Response& response, float time_s) noexcept {
  if (!is_valid(response)) return {};
  const Response& r = response;
  const float t = std::isfinite(time_s) ? std::max(time_s, 0.0F) : 0.0F;
  if (t <= r.start_s && r.origin.idles) return source_pose_at(r, t);
  if (t >= duration_s(r)) return home_pose_at(r, t);
  Pose pose = body_at(r, t);
  const Eigen::Vector3f shift = weight_shift_at(r, t);
  if (shift.isZero(0) && is_untouched_clip(r, t)) return pose;

  const motion::Skeleton& skeleton = r.library->skeleton();
  JointFrames frames = motion::forward_kinematics(skeleton, pose, kLegs);
  motion::PerSide<FootPlace> feet;
  for (Side side : motion::kSides) {
    feet[motion::index_of(side)] =
        above_ground(r, side, foot_at(r, side, t), pose.rotation[motion::roles_of(side).toes]);
  }
  const Eigen::Vector3f move =
      shift + way_down(skeleton, frames, shift, feet) * Eigen::Vector3f::UnitZ();
  pose.root_position += move;
  for (Role role : kLegs) frames.position[role] += move;
  for (Side side : motion::kSides) {
    const FootPlace& foot = feet[motion::index_of(side)];
    motion::move_limb_end(frames, motion::leg_of(side), foot.ankle, foot.orientation, pose);
  }
  return pose;
}

bool is_valid(const Response& response) noexcept {
  return response.library != nullptr;
}

float duration_s(const Response& response) noexcept {
  if (!is_valid(response)) return 0;
  return response.end_s + response.return_s;
}

}  // namespace flinch::runtime
