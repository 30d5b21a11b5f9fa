// SPDX-License-Identifier: MIT
#include "runtime/response/response.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;

/// The joints that decide where the feet are.
constexpr std::array kLegRoles{Role::pelvis,    Role::left_thigh,  Role::left_shin,
                               Role::left_foot, Role::right_thigh, Role::right_shin,
                               Role::right_foot};

float fraction_of(const Interval& interval, float time_s) {
  if (time_s <= interval.begin_s) return 0;
  if (time_s >= interval.end_s) return 1;
  return (time_s - interval.begin_s) / (interval.end_s - interval.begin_s);
}

// A step at fraction u of its interval. The height 64 u^3 (1 - u)^3 leaves and meets the ground
// without a jolt; the foot is lifted before it moves forward and arrives before it is put down.
FootPose step_between(const FootPose& from, const FootPose& to, float u, float lift_m) {
  constexpr float kLiftShare = 0.1F;
  const float weight = motion::minimum_jerk((u - kLiftShare) / (1 - 2 * kLiftShare));
  FootPose place = blend(from, to, weight);
  place.ankle.z() += lift_m * 64 * u * u * u * (1 - u) * (1 - u) * (1 - u);
  return place;
}

// A foot that follows its clip from where it stood. The two places differ in height and tilt alone,
// and the weight fades that difference out. Blending the places themselves would drag a foot that
// the clip lifts over the ground.
FootPose continuous_foot(const FootPlan& plan, const FootPose& clip, float weight) {
  const Eigen::Quaternionf orientation =
      motion::slerp(plan.tilt, Eigen::Quaternionf::Identity(), weight) * clip.orientation;
  return {clip.ankle + (1 - weight) * plan.rise +
              (clip.orientation * plan.pivot - orientation * plan.pivot),
          orientation};
}

bool has_landed(const Landing& landing, float time_s) {
  return !std::isfinite(landing.interval.end_s) || time_s >= landing.interval.end_s;
}

// A foot that comes down where it will stand: a cubic curve from where it swung, with its velocity.
// Along the ground it arrives before it touches.
FootPose landing_foot(const Landing& landing, const FootPose& stand, float time_s) {
  constexpr float kArrived = 0.8F;  // of the interval, along the ground
  constexpr float kLift_m = 0.03F;  // beside its own way
  if (has_landed(landing, time_s)) return stand;
  const float u = fraction_of(landing.interval, time_s);
  const auto left = [](float s) { return 1 - s * s * (3 - 2 * s); };
  const auto going = [](float s) { return s * (1 - s) * (1 - s); };
  const float duration_s = landing.interval.end_s - landing.interval.begin_s;
  const float along = std::min(u / kArrived, 1.0F);
  FootPose foot = stand;
  foot.ankle.head<2>() += left(along) * landing.way.head<2>() +
                          going(along) * kArrived * duration_s * landing.velocity.head<2>();
  foot.ankle.z() += left(u) * landing.way.z() + going(u) * duration_s * landing.velocity.z() +
                    16 * kLift_m * u * u * (1 - u) * (1 - u);
  foot.orientation =
      motion::slerp(landing.tilt, Eigen::Quaternionf::Identity(), motion::minimum_jerk(along)) *
      stand.orientation;
  return foot;
}

FootPose moved(const FootPose& place, const motion::PlanarMove& move) {
  const Eigen::Quaternionf turn = motion::rotation_about(Eigen::Vector3f::UnitZ(), move.yaw);
  return {turn * place.ankle + move.translation, turn * place.orientation};
}

float blend_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.begin_s) / r.blend_duration_s);
}

float return_weight(const Response& r, float time_s) {
  return motion::minimum_jerk((time_s - r.end_s) / r.return_duration_s);
}

float clip_time_at(const Response& r, float time_s) {
  return r.library->clip(r.clip).annotation->onset_s + r.playback_rate * (time_s - r.begin_s);
}

// The arcs of a blend that began at `start_s` along `arcs`. They go by the signs that the rotations
// had then. A sample has those of the pose stored before it, which mean nothing else.
template <class StanceAt>
motion::Signs arcs_at(const Response& r, motion::Signs arcs, float start_s, float time_s,
                      const StanceAt& stance_at, std::span<const Role> roles) {
  const auto clip_at = [&r](float at_s) -> const Pose& {
    if (r.clip == kNoClip) return r.brace.sustained;
    return motion::pose_before(r.library->clip(r.clip).motion, clip_time_at(r, at_s));
  };
  motion::change_signs(stance_at(start_s), stance_at(time_s), roles, arcs);
  motion::change_signs(clip_at(start_s), clip_at(time_s), roles, arcs);
  return arcs;
}

motion::Signs arcs_in_at(const Response& r, float time_s, std::span<const Role> roles) {
  const motion::Loop& rest = r.library->rest_of(r.rest).loop;
  const auto rest_at = [&](float at_s) -> const Pose& {
    return motion::pose_before(rest, r.rest.idle_time_s + at_s - r.leave_s);
  };
  return arcs_at(r, r.arcs_in, r.begin_s, time_s, rest_at, roles);
}

motion::Signs arcs_back_at(const Response& r, float time_s, std::span<const Role> roles) {
  const motion::Loop& home = r.library->stance_of(r.home).loop;
  const auto home_at = [&](float at_s) -> const Pose& {
    return motion::pose_before(home, r.home.idle_time_s + home_time_s(r, at_s));
  };
  return arcs_at(r, r.arcs_back, r.end_s, time_s, home_at, roles);
}

Samples::Of motions_at(const Response& r, float t) {
  const bool goes_on = r.inertialization.is_zero || t < r.leave_s;
  if (t <= r.first_motion_s && goes_on) return Samples::Of::source_untouched;
  if (t >= duration_s(r)) return Samples::Of::home;
  if (is_idle(r)) return Samples::Of::source_and_home;
  if (t <= r.begin_s) return Samples::Of::source;
  if (t < r.begin_s + r.blend_duration_s) return Samples::Of::source_and_clip;
  return t <= r.end_s ? Samples::Of::clip : Samples::Of::clip_and_home;
}

// By how much a foot must come up to be at most so deep in the ground, m: 0 or more.
float rise_to_ground(const Response& r, Side side, const FootPose& place,
                     const Eigen::Quaternionf& toes, float max_depth_m) {
  const float lowest = min_height(r.library->soles[side], place, toes,
                                  r.library->skeleton().offset[motion::roles_of(side).toes]);
  return std::max(-max_depth_m - lowest, 0.0F);
}

// Keeps a foot above the ground: between a clip and a source that differ much it may dip.
FootPose above_ground(const Response& r, Side side, FootPose place,
                      const Eigen::Quaternionf& toes) {
  constexpr float kMaxDepth_m = 0.001F;
  place.ankle.z() += rise_to_ground(r, side, place, toes, kMaxDepth_m);
  return place;
}

// The place of a foot that has landed, which does not depend on the pelvis.
FootPose standing_foot_at(const Response& r, Side side, const Samples& samples) {
  const FootPlan& plan = r.feet[side];
  const float t = samples.time_s;
  if (samples.of == Samples::Of::source) return source_foot_in(r, side, samples.from);
  if (samples.of == Samples::Of::source_and_clip)
    return continuous_foot(plan, clip_foot_in(r, side, *samples.to, t), blend_weight(r, t));
  const FootPose away =
      is_idle(r) ? source_foot_in(r, side, samples.from) : clip_foot_in(r, side, samples.from, t);
  if (t <= plan.return_step.begin_s) return away;
  const FootPose home = foot_of(r.library->skeleton(), *samples.to, side);
  const float u = fraction_of(plan.return_step, t);
  if (plan.return_lift_m > 0) return step_between(away, home, u, plan.return_lift_m);
  return blend(away, home, motion::minimum_jerk(u));
}

FootPose foot_at(const Response& r, Side side, const Samples& samples) {
  return landing_foot(r.landings[side], standing_foot_at(r, side, samples), samples.time_s);
}

// Whether both feet are exactly where the clip has them.
bool has_clips_feet(const Response& r, float t) {
  const auto lands = [t](const Landing& landing) { return !has_landed(landing, t); };
  return std::ranges::none_of(r.landings, lands) &&
         std::ranges::none_of(r.feet, [t](const FootPlan& plan) {
           const bool is_offset = plan.offset.yaw != 0 || !plan.offset.translation.isZero(0);
           return is_offset && t < plan.correction.end_s;
         });
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
    const float highest = motion::max_upper_height(hip, feet[side].ankle, reach);
    drop = std::min(drop, highest - hip.z());
  }
  return std::max(drop, kMinPelvisDrop_m);
}

// Clamps a joint to its limits, or to where `motion` has it beyond them. Returns whether it moved.
bool clamp_joint(const motion::JointLimits& limits, const Eigen::Quaternionf& motion, Pose& pose) {
  const Eigen::Quaternionf clamped =
      motion::clamp_to_limits(limits, pose.rotation[limits.to], motion);
  const bool moves = clamped.coeffs() != pose.rotation[limits.to].coeffs();
  pose.rotation[limits.to] = clamped;
  return moves;
}

// On what a foot turns that comes from a stance, in its own frame: on its heel where it is flat,
// and the more on its ball the more its heel is up.
Eigen::Vector3f turning_point(const motion::Skeleton& skeleton, Side side,
                              const Eigen::Quaternionf& foot) {
  constexpr float kOnBall = 0.15F;  // sine of the angle to the ground
  const motion::FootDimensions dimensions = motion::measure_foot(skeleton, side);
  const float heel_up = std::clamp(-(foot * dimensions.forward).z() / kOnBall, 0.0F, 1.0F);
  const Eigen::Vector3f& ball = skeleton.offset[motion::roles_of(side).toes];
  return dimensions.heel + heel_up * (ball - dimensions.heel);
}

// The way of the ankle where a foot tilts, m: it rolls over its sole, whose points on the ground
// stay, as they all lie about as far below the ankle. One that comes from a stance may be turned
// far out, or lifted while its heel is up: it turns on one point, which keeps its height too.
Eigen::Vector3f roll_over_sole(const Response& r, Side side, const FootPose& foot,
                               const Eigen::Quaternionf& tilted) {
  if (!r.feet[side].pivot.isZero(0)) {
    const Eigen::Vector3f point = turning_point(r.library->skeleton(), side, tilted);
    return foot.orientation * point - tilted * point;
  }
  const float depth_m =
      motion::min_height(r.library->soles[side].foot, Eigen::Quaternionf::Identity());
  const Eigen::Vector3f sole = depth_m * Eigen::Vector3f::UnitZ();
  return horizontal(foot.orientation * sole - tilted * sole);
}

// Moves a leg to its foot. Where the body comes from another motion or hurries into its clip, the
// foot may be where the hip and the ankle cannot follow. Then it comes as near as they allow, above
// the ground, which needs a new solution; each comes nearer. `frames` belong to `pose`, which is as
// it was blended: joints may be as far beyond their limits as it has them.
bool move_leg(const Response& r, Side side, const JointFrames& frames, const FootPose& foot,
              Pose& pose) {
  constexpr int kRounds = 4;
  const motion::Limb leg = motion::leg_of(side);
  const PreparedLibrary::LegLimits& limits = r.library->leg_limits[side];
  const Eigen::Quaternionf blended_hip = pose.rotation[limits.hip->to];
  const Eigen::Quaternionf blended_ankle = pose.rotation[limits.ankle->to];
  motion::move_limb_end(frames, leg, foot.ankle, foot.orientation, pose);
  for (int round = 0; round < kRounds; ++round) {
    const bool hip_moves = clamp_joint(*limits.hip, blended_hip, pose);
    const bool ankle_moves = clamp_joint(*limits.ankle, blended_ankle, pose);
    if (!hip_moves && !ankle_moves) return true;
    FootPose near = foot_of(r.library->skeleton(), pose, side);
    if (!ankle_moves) near.orientation = foot.orientation;
    if (!hip_moves) near.ankle = foot.ankle + roll_over_sole(r, side, foot, near.orientation);
    near = above_ground(r, side, near, pose.rotation[motion::roles_of(side).toes]);
    motion::move_limb_end(frames, leg, near.ankle, near.orientation, pose);
  }
  const bool hip_moves = clamp_joint(*limits.hip, blended_hip, pose);
  const bool ankle_moves = clamp_joint(*limits.ankle, blended_ankle, pose);
  return !hip_moves && !ankle_moves;
}

// The pelvis was lowered where a foot is out of the leg's reach. A leg that its hip's or ankle's
// limit then stops may have its foot under the ground: the pelvis is raised by that depth, and the
// other leg is solved again from there.
void raise_soles(const Response& r, const motion::PerSide<FootPose>& feet, JointFrames& frames,
                 Pose& pose) {
  constexpr float kMaxDepth_m = 0.005F;
  motion::PerSide<float> rise{};
  for (Side side : motion::kSides)
    rise[side] = rise_to_ground(r, side, foot_of(r.library->skeleton(), pose, side),
                                pose.rotation[motion::roles_of(side).toes], kMaxDepth_m);
  const Side lower = rise[Side::left] > rise[Side::right] ? Side::left : Side::right;
  if (rise[lower] <= 0) return;
  const Eigen::Vector3f move = rise[lower] * Eigen::Vector3f::UnitZ();
  pose.root_position += move;
  for (Role role : kLegRoles) frames.position[role] += move;
  move_leg(r, motion::other(lower), frames, feet[motion::other(lower)], pose);
}

}  // namespace

bool is_idle(const Response& response) noexcept {
  return response.clip == response.library->library->idle;
}

Eigen::Vector3f horizontal(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), 0};
}

Pose source_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  if (time_s < r.leave_s)
    return features::idle_pose(r.library->stance_of(r.state).loop, r.state, time_s, roles);
  return inertialized_pose(*r.library, r.rest, r.inertialization, time_s - r.leave_s, roles);
}

Pose return_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  Pose pose =
      features::idle_pose(r.library->stance_of(r.home).loop, r.home, home_time_s(r, time_s), roles);
  pose.root_position += r.idle_displacement;
  return pose;
}

// From rest to a rate of 1 in T = kWalkOn_s: s^2 / (2 T), then s - T / 2.
float home_time_s(const Response& r, float time_s) noexcept {
  if (r.walk_on_s < 0) return time_s;
  const float since_s = std::max(time_s - r.walk_on_s, 0.0F);
  return since_s < kWalkOn_s ? since_s * since_s / (2 * kWalkOn_s) : since_s - kWalkOn_s / 2;
}

Pose brace_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  const Brace& brace = r.brace;
  if (brace.startle_s <= 0) return brace.sustained;
  const float startled_s = r.begin_s + brace.startle_s;
  const float weight = motion::minimum_jerk((time_s - startled_s) / (r.peak_s - startled_s));
  return motion::blend(brace.startled, brace.sustained, weight, roles);
}

Pose clip_pose_at(const Response& r, float time_s, std::span<const Role> roles) {
  if (r.clip == kNoClip) return brace_pose_at(r, time_s, roles);
  Pose pose = motion::sample(r.library->clip(r.clip).motion, clip_time_at(r, time_s), roles);
  motion::place(r.yaw, r.translation, pose);
  return pose;
}

FootPose source_foot_in(const Response& r, Side side, const Pose& source) {
  if (!r.inertialization.is_zero && r.inertialization.stands[side])
    return r.inertialization.foot[side];
  return foot_of(r.library->skeleton(), source, side);
}

FootPose clip_foot_in(const Response& r, Side side, const Pose& clip, float time_s) {
  const FootPlan& plan = r.feet[side];
  const FootPose own = foot_of(r.library->skeleton(), clip, side);
  const float u = fraction_of(plan.correction, time_s);
  if (u >= 1) return own;
  const FootPose offset = moved(own, plan.offset);
  if (u <= 0) return offset;
  if (plan.correction_lift_m > 0) return step_between(offset, own, u, plan.correction_lift_m);
  return blend(offset, own, motion::minimum_jerk(u));
}

FootPose source_foot_at(const Response& r, Side side, float time_s) {
  return source_foot_in(r, side, source_pose_at(r, time_s, leg_chain(side)));
}

FootPose clip_foot_at(const Response& r, Side side, float time_s) {
  return clip_foot_in(r, side, clip_pose_at(r, time_s, leg_chain(side)), time_s);
}

FootPose return_foot_at(const Response& r, Side side, float time_s) {
  return foot_of(r.library->skeleton(), return_pose_at(r, time_s, leg_chain(side)), side);
}

Eigen::Vector3f weight_shift_at(const Response& r, float t) {
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  for (const WeightShift& part : r.shifts) {
    if (t <= part.interval.begin_s || t >= part.interval.end_s) continue;
    const Interval up{part.interval.begin_s, part.hold.begin_s};
    const Interval down{part.hold.end_s, part.interval.end_s};
    const float weight =
        motion::minimum_jerk(fraction_of(up, t)) - motion::minimum_jerk(fraction_of(down, t));
    if (weight > 0) shift += weight * part.pelvis;
  }
  return shift;
}

Samples samples_at(const Response& r, float t, std::span<const Role> roles) {
  const Samples::Of of = motions_at(r, t);
  switch (of) {
    case Samples::Of::source_untouched:
    case Samples::Of::source:
      return {of, t, source_pose_at(r, t, roles), std::nullopt};
    case Samples::Of::source_and_clip:
      return {of, t, source_pose_at(r, t, roles), clip_pose_at(r, t, roles)};
    case Samples::Of::clip:
      return {of, t, clip_pose_at(r, t, roles), std::nullopt};
    case Samples::Of::clip_and_home:
      return {of, t, clip_pose_at(r, t, roles), return_pose_at(r, t, roles)};
    case Samples::Of::source_and_home:
      return {of, t, source_pose_at(r, t, roles), return_pose_at(r, t, roles)};
    case Samples::Of::home:
      break;
  }
  return {of, t, return_pose_at(r, t, roles), std::nullopt};
}

Pose blended(const Response& r, const Samples& samples, std::span<const Role> roles) {
  const float t = samples.time_s;
  switch (samples.of) {
    case Samples::Of::source_and_clip:
      return motion::blend_along(samples.from, *samples.to, blend_weight(r, t),
                                 arcs_in_at(r, t, roles), roles);
    case Samples::Of::clip_and_home:
      return motion::blend_along(samples.from, *samples.to, return_weight(r, t),
                                 arcs_back_at(r, t, roles), roles);
    case Samples::Of::source_and_home:
      return motion::blend(samples.from, *samples.to, return_weight(r, t), roles);
    default:
      return samples.from;
  }
}

bool must_place_feet(const Response& r, const Samples& samples, const Eigen::Vector3f& shift) {
  if (samples.of == Samples::Of::source_untouched || samples.of == Samples::Of::home) return false;
  return samples.of != Samples::Of::clip || !shift.isZero(0) || !has_clips_feet(r, samples.time_s);
}

Legs legs_of(const Response& r, const Samples& samples, const Pose& blended) {
  Legs legs;
  legs.frames = motion::forward_kinematics(r.library->skeleton(), blended, kLegRoles);
  for (Side side : motion::kSides) {
    legs.feet[side] = above_ground(r, side, foot_at(r, side, samples),
                                   blended.rotation[motion::roles_of(side).toes]);
  }
  return legs;
}

void place_feet(const Response& r, const Legs& legs, const Eigen::Vector3f& shift, Pose& pose) {
  const Eigen::Vector3f move =
      shift +
      pelvis_drop(r.library->skeleton(), legs.frames, shift, legs.feet) * Eigen::Vector3f::UnitZ();
  pose.root_position += move;
  JointFrames frames = legs.frames;
  for (Role role : kLegRoles) frames.position[role] += move;
  bool reach = true;
  for (Side side : motion::kSides) reach &= move_leg(r, side, frames, legs.feet[side], pose);
  if (!reach) raise_soles(r, legs.feet, frames, pose);
}

Pose pose_at(const Response& response, float time_s) noexcept {
  if (!is_valid(response)) return {};
  const float t = std::isfinite(time_s) ? std::max(time_s, 0.0F) : 0.0F;
  const Samples samples = samples_at(response, t);
  Pose pose = blended(response, samples);
  const Eigen::Vector3f shift = weight_shift_at(response, t);
  if (must_place_feet(response, samples, shift))
    place_feet(response, legs_of(response, samples, pose), shift, pose);
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
