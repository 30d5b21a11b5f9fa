// SPDX-License-Identifier: MIT
// Plans responses: when the clip plays, where the feet go and how the weight is shifted.
#include <algorithm>
#include <array>
#include <cmath>

#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "runtime/response/brace.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Role;
using motion::Side;

constexpr float kShiftDuration_s = 0.3F;        // of a weight shift where there is time
constexpr float kMinShiftDuration_s = 0.15F;    // of a weight shift
constexpr float kReturnShiftDuration_s = 0.4F;  // of the shift before a step on the way back
constexpr float kShiftBackDuration_s = 0.45F;   // from the shifted weight back
constexpr float kHoldBeforeLift_s = 0.04F;      // shifted, before a foot leaves the ground
constexpr float kHoldAfterLift_s = 0.025F;      // shifted, after it left
constexpr float kStepDuration_s = 0.25F;        // of a step that is not in the clip
constexpr float kPauseAfterSteps_s = 0.1F;      // after the last step on the way back
constexpr float kSettleDuration_s = 0.6F;       // from another motion to idle
constexpr float kStandstill_s = 0.15F;          // from leaving a walk to the clip
constexpr float kBeforePassing_s = 0.05F;       // of a walk: where it begins anew
constexpr float kSamePosition_m = 1e-3F;        // offset of a foot that needs no step
constexpr float kSameYaw = 3e-3F;               // radians
constexpr float kToleratedOffset_m = 0.04F;     // offset that a foot may keep during a clip
constexpr float kToleratedYaw = 0.15F;          // radians

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

bool is_usable_start(const PreparedLibrary& prepared, const features::CharacterState& state,
                     float time_to_impact_s, const Inertialization& inertialization) {
  return prepared.library != nullptr && has_clip(*prepared.library, prepared.library->idle) &&
         is_finite(state) && is_finite(inertialization) && prepared.has_stance(state.stance) &&
         time_to_impact_s > 0 && std::isfinite(time_to_impact_s);
}

bool is_usable_input(const PreparedLibrary& prepared, const features::CharacterState& state,
                     int clip, float time_to_impact_s, const Inertialization& inertialization) {
  if (!is_usable_start(prepared, state, time_to_impact_s, inertialization)) return false;
  const database::ClipLibrary& library = *prepared.library;
  if (!has_clip(library, clip)) return false;
  const auto& annotation = library.clip(clip).annotation;
  return clip == library.idle || (annotation && is_in_order(*annotation));
}

float yaw_between(const FootPose& from, const FootPose& to) {
  return motion::wrapped_to_pi(motion::yaw_of(to.orientation) - motion::yaw_of(from.orientation));
}

bool differ(const FootPose& a, const FootPose& b, float distance_m, float yaw) {
  return horizontal(a.ankle - b.ankle).norm() > distance_m || std::abs(yaw_between(b, a)) > yaw;
}

float step_height(const FootPose& from, const FootPose& to) {
  return std::clamp(0.25F * horizontal(to.ankle - from.ankle).norm(), 0.02F, 0.06F);
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

// What is blended when the clip begins.
struct Start {
  motion::Pose source;
  motion::Pose clip;
};

// Lays the clip's support foot on the character's.
Start align(Response& r) {
  r.yaw = r.rest.facing;
  r.translation = Eigen::Vector3f::Zero();
  Start start{source_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s)};
  r.translation = horizontal(source_foot_in(r, r.support, start.source).ankle -
                             foot_of(r.library->skeleton(), start.clip, r.support).ankle);
  start.clip.root_position += r.translation;
  return start;
}

Interval response_interval(const Response& r, const Swing& swing) {
  const float onset_s = r.library->clip(r.clip).annotation->onset_s;
  return {r.begin_s + (swing.begin_s - onset_s) / r.playback_rate,
          r.begin_s + (swing.end_s - onset_s) / r.playback_rate};
}

// None of a response by rule.
const Footwork& footwork_of(const Response& r) {
  static const Footwork kNone;
  if (r.clip == kNoClip) return kNone;
  return r.library->footwork[static_cast<std::size_t>(r.clip)];
}

// The first swing of a foot by which it can go to where the clip has it.
std::optional<Interval> first_swing(const Response& r, Side side) {
  const std::vector<Swing>& swings = footwork_of(r).swings[side];
  if (swings.empty()) return std::nullopt;
  const Interval interval = response_interval(r, swings.front());
  if (interval.begin_s >= r.end_s) return std::nullopt;
  return interval;
}

// Where the foot of a clip that has it elsewhere goes there.
void plan_change(Response& r, Side side, const FootPose& from, const FootPose& to) {
  FootPlan& plan = r.feet[side];
  const std::optional<Interval> swing = first_swing(r, side);
  if (swing) plan.correction = *swing;
  const bool must_step = side != r.support && differ(from, to, kToleratedOffset_m, kToleratedYaw);
  if (must_step && !(swing && swing->begin_s < r.begin_s + r.blend_duration_s)) {
    const float begin_s = std::max(r.begin_s, r.leave_s + kMinShiftDuration_s);
    if (swing && swing->begin_s < begin_s + kStepDuration_s)
      return;  // the clip's own comes soon enough
    plan.correction = {begin_s, begin_s + kStepDuration_s};
    plan.correction_lift_m = step_height(from, to);
  }
}

void plan_foot(Response& r, Side side, const Start& start) {
  FootPlan& plan = r.feet[side];
  plan = {};
  const FootPose from = source_foot_in(r, side, start.source);
  const FootPose to = foot_of(r.library->skeleton(), start.clip, side);
  if (differ(from, to, 1e-5F, 1e-4F)) {
    plan.offset.yaw = yaw_between(to, from);
    plan.offset.translation = horizontal(
        from.ankle - motion::rotation_about(Eigen::Vector3f::UnitZ(), plan.offset.yaw) * to.ankle);
  }
  plan_change(r, side, from, to);
  const FootPose clip = clip_foot_in(r, side, start.clip, r.begin_s);
  plan.rise = from.ankle - clip.ankle;
  plan.tilt = from.orientation * clip.orientation.conjugate();
}

// How far a point is from being kMargin inside of a sole, on the way to the sole's middle. Whole
// steps of 1/4096 of that way hide what rounding does to the fraction, and with it to every later
// pose.
Eigen::Vector2f offset_to_sole(const Sole& sole, const Eigen::Vector2f& point) {
  constexpr float kMargin = 0.015F;      // m
  constexpr float kTolerance_m = 1e-4F;  // by which a point may be nearer to the edge
  constexpr float kSteps = 4096;
  if (motion::fraction_to_inside(kMargin - kTolerance_m, sole.hull, point, sole.middle) <= 0)
    return {0, 0};
  const float fraction = motion::fraction_to_inside(kMargin, sole.hull, point, sole.middle);
  return std::ceil(kSteps * fraction) / kSteps * (sole.middle - point);
}

// Finds the pelvis' way of a shift, one of the response's, that brings the centre of mass over the
// sole of a foot. A pelvis takes most of the body along; the feet stay, so it must go a little
// farther.
void solve_pelvis_shift(const Response& r, Side side, float lift_s, WeightShift& shift) {
  constexpr float kOvershoot = 1.17F;
  constexpr float kDipPerShift = 0.2F;     // knees give, and need not straighten suddenly
  constexpr float kMaxShiftSpeed = 1.35F;  // m/s, mean: what is lacking then is left to momentum
  constexpr int kIterations = 6;
  const PreparedLibrary& library = *r.library;
  const float max_distance_m = kMaxShiftSpeed * (shift.hold.begin_s - shift.interval.begin_s);
  shift.pelvis = Eigen::Vector3f::Zero();
  const Samples samples = samples_at(r, lift_s);
  const motion::Pose unshifted = blended(r, samples);
  const Legs legs = legs_of(r, samples, unshifted);
  for (int round = 0; round < kIterations; ++round) {
    motion::Pose pose = unshifted;
    const Eigen::Vector3f weight_shift = weight_shift_at(r, lift_s);
    if (must_place_feet(r, samples, weight_shift)) place_feet(r, legs, weight_shift, pose);
    const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), pose);
    const FootPose foot = motion::foot_pose(frames, side);
    const Eigen::Quaternionf heading =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
    const Eigen::Vector3f centre = motion::centre_of_mass(library.body_model, frames);
    const Eigen::Vector2f in_sole =
        (heading.conjugate() * horizontal(centre - foot.ankle)).head<2>();
    const Eigen::Vector2f missing = offset_to_sole(library.soles[side], in_sole);
    if (missing.norm() <= 0) break;
    shift.pelvis += kOvershoot * (heading * Eigen::Vector3f(missing.x(), missing.y(), 0));
    const float distance = horizontal(shift.pelvis).norm();
    if (distance > max_distance_m) shift.pelvis *= max_distance_m / distance;
    shift.pelvis.z() = -kDipPerShift * horizontal(shift.pelvis).norm();
  }
}

// Shifts the weight over a foot, from `begin_s` on, before the other leaves the ground at `lift_s`.
void shift_weight(Response& r, std::size_t number, Side over, float lift_s, float begin_s,
                  float latest_s) {
  WeightShift& shift = r.shifts[number];
  shift.hold = {lift_s - kHoldBeforeLift_s, lift_s + kHoldAfterLift_s};
  shift.interval = {begin_s, std::min(lift_s + kShiftBackDuration_s, latest_s)};
  solve_pelvis_shift(r, over, lift_s, shift);
  if (shift.pelvis.isZero(0)) shift = {};
}

// When the other foot first leaves the ground, if it does before the clip's peak.
std::optional<float> first_lift_s(const Response& r) {
  const Side other = motion::other(r.support);
  const FootPlan& plan = r.feet[other];
  std::optional<float> lift_s;
  if (plan.correction_lift_m > 0) lift_s = plan.correction.begin_s;
  const std::optional<Interval> swing = first_swing(r, other);
  if (swing && (!lift_s || swing->begin_s < *lift_s)) lift_s = swing->begin_s;
  if (lift_s && *lift_s >= r.peak_s && plan.correction_lift_m <= 0) return std::nullopt;
  return lift_s;
}

/// Joints whose velocities are compared, with the roles that their poses need: asked for at many
/// times, poses of some joints cost less than whole ones.
struct Group {
  std::span<const Role> compared;
  std::span<const Role> needed;
  bool is_placed;  // by the third stage
};

constexpr std::array kLegs{Role::left_thigh,  Role::left_shin,  Role::left_foot,
                           Role::right_thigh, Role::right_shin, Role::right_foot};
constexpr std::array kLegsAndToes{Role::pelvis,     Role::left_thigh, Role::left_shin,
                                  Role::left_foot,  Role::left_toes,  Role::right_thigh,
                                  Role::right_shin, Role::right_foot, Role::right_toes};
constexpr bool is_of_legs(Role role) {
  return std::ranges::count(kLegs, role) > 0;
}
constexpr auto kOthers = [] {
  std::array<Role, motion::kRoleCount - kLegs.size()> others{};
  std::ranges::copy_if(motion::kRoles, others.begin(), [](Role role) { return !is_of_legs(role); });
  return others;
}();

// A turn between two poses with a positive scalar part, so that its vector part v points along its
// rotation vector, 2 asin(|v|) v / |v|.
Eigen::Quaternionf turn_of(Role role, const motion::Pose& from, const motion::Pose& to) {
  Eigen::Quaternionf turn = to.rotation[role] * from.rotation[role].conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return turn;
}

// A cheap bound of the difference of two turns' rotation vectors: where both |v| are below 1/4,
// they differ by at most 2 / sqrt(1 - 1/16) = 2.07 times what the vector parts do.
float max_difference(const Eigen::Quaternionf& first, const Eigen::Quaternionf& second) {
  constexpr float kSmall = 1.0F / 16;
  constexpr float kRounding = 1e-6F;
  if (!(first.vec().squaredNorm() < kSmall && second.vec().squaredNorm() < kSmall))
    return std::numeric_limits<float>::infinity();
  return 2.08F * (second.vec() - first.vec()).norm() + kRounding;
}

/// The joint whose velocity changes most, and by how much.
struct VelocityChange {
  float max = 0;  // rad per frame
  Role role = Role::pelvis;
};

// The largest change of the velocity of one of these joints from one pair of poses to the next; at
// least `change`. Most joints need not be looked at closely.
VelocityChange max_velocity_change(const std::array<motion::Pose, 3>& poses,
                                   std::span<const Role> roles, VelocityChange change) {
  for (Role role : roles) {
    const Eigen::Quaternionf first = turn_of(role, poses[0], poses[1]);
    const Eigen::Quaternionf second = turn_of(role, poses[1], poses[2]);
    if (max_difference(first, second) < change.max) continue;
    const float here = (motion::rotation_vector(second) - motion::rotation_vector(first)).norm();
    if (here > change.max) change = {here, role};
  }
  return change;
}

motion::Pose pose_of(const Response& r, float time_s, const Group& group) {
  const Samples samples = samples_at(r, time_s, group.needed);
  motion::Pose pose = blended(r, samples, group.needed);
  if (!group.is_placed) return pose;
  const Eigen::Vector3f shift = weight_shift_at(r, time_s);
  if (must_place_feet(r, samples, shift)) place_feet(r, legs_of(r, samples, pose), shift, pose);
  return pose;
}

constexpr float kFrame_s = 1.0F / 60;

// The largest change of a joint's velocity about a time, from one frame to the next. Stops at a
// change above `enough` rad/s, and looks first where that is likely: at the joint `suspect`.
VelocityChange velocity_change_at(const Response& r, float time_s,
                                  const std::optional<Role>& suspect, float enough) {
  constexpr Group kOfLegs{kLegs, kLegsAndToes, true};
  constexpr Group kOfOthers{kOthers, kOthers, false};
  std::array groups{kOfOthers, kOfOthers, kOfLegs};
  auto to_look_at = std::span<const Group>(groups).last(2);
  if (suspect && is_of_legs(*suspect)) {
    std::swap(groups[1], groups[2]);
  } else if (suspect) {
    groups[0] = {{&*suspect, 1}, {&*suspect, 1}, false};
    to_look_at = groups;
  }
  VelocityChange change;
  for (const Group& group : to_look_at) {
    change = max_velocity_change({pose_of(r, time_s - kFrame_s, group), pose_of(r, time_s, group),
                                  pose_of(r, time_s + kFrame_s, group)},
                                 group.compared, change);
    if (change.max / kFrame_s > enough) break;
  }
  return change;
}

// What is left of a blend adds to what the clip does: of its possible ends, the blend takes the
// one with the smallest change of velocity, and of equals the first. The likeliest ends are tried
// first, so that the others can be given up early.
void choose_blend_duration(Response& r) {
  constexpr std::array kLonger_s{0.06F, 0.08F, 0.0F, 0.02F, 0.04F};
  Response tried = r;
  std::optional<Role> suspect;
  float min_change = std::numeric_limits<float>::infinity();
  for (float longer_s : kLonger_s) {
    tried.blend_duration_s = kMinBlend_s + longer_s;
    if (tried.blend_duration_s > r.peak_s - r.begin_s) continue;
    const VelocityChange change =
        velocity_change_at(tried, tried.begin_s + tried.blend_duration_s, suspect, min_change);
    suspect = change.role;
    const float step = change.max / kFrame_s;
    if (step < min_change || (step == min_change && tried.blend_duration_s < r.blend_duration_s)) {
      min_change = step;
      r.blend_duration_s = tried.blend_duration_s;
    }
  }
}

void plan_clip(const motion::Annotation& annotation, float time_to_impact_s, float earliest_s,
               Response& r) {
  set_timing(annotation, time_to_impact_s, earliest_s, r);
  const Start start = align(r);
  for (Side side : motion::kSides) plan_foot(r, side, start);
  r.arcs_in = motion::shorter_arcs(start.source, start.clip);
  r.shifts[0] = {};
  const std::optional<float> lift_s = first_lift_s(r);
  const auto shift = [&] {
    shift_weight(r, 0, r.support, *lift_s, std::max(*lift_s - kShiftDuration_s, r.leave_s),
                 r.end_s);
  };
  if (lift_s) shift();
  choose_blend_duration(r);
  const bool is_lifted_meanwhile = lift_s && *lift_s < r.begin_s + r.blend_duration_s;
  if (is_lifted_meanwhile) shift();
}

// The foot that carries more weight in the pose where the way home begins.
Side weight_bearing_foot(const Response& r, const motion::Pose& away) {
  constexpr float kClearlyNearer_m = 0.02F;  // m, by which the other must be nearer
  const PreparedLibrary& library = *r.library;
  const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), away);
  const Eigen::Vector3f centre = motion::centre_of_mass(library.body_model, frames);
  const auto distance = [&](Side side) {
    return horizontal(motion::foot_pose(frames, side).ankle - centre).norm();
  };
  const Side other = motion::other(r.support);
  return distance(other) < distance(r.support) - kClearlyNearer_m ? other : r.support;
}

// A foot where the way home begins, or after it.
FootPose away_foot(const Response& r, Side side, float time_s) {
  return is_idle(r) ? source_foot_at(r, side, time_s) : clip_foot_at(r, side, time_s);
}

// A walking character goes on until shortly before the clip. From then on it comes to rest, and the
// rest of the plan is that for any character that rests in another pose.
void plan_leaving(Response& r) {
  constexpr float kVelocityInterval_s = 1.0F / 240;
  const PreparedLibrary& library = *r.library;
  r.leave_s = std::max(r.begin_s - kStandstill_s, 0.0F);
  const motion::Loop& walk = library.stance_of(r.state).loop;
  const motion::Pose now = features::idle_pose(walk, r.state, r.leave_s);
  const motion::Pose before = features::idle_pose(walk, r.state, r.leave_s - kVelocityInterval_s);
  r.rest =
      rest_state_at(library, now, r.state.stance, features::later(walk, r.state, r.leave_s).facing);
  r.inertialization = make_inertialization(library, r.rest, before, now, kVelocityInterval_s);
}

// A walk goes on where one foot stands, the other free to pass it: `standing` is the last foot to
// carry the body.
void plan_walking_on(Response& r, const motion::Pose& away, Side standing) {
  const Passing& passing = r.library->stance_of(r.home).passing[standing];
  FootPlan& free = r.feet[motion::other(standing)];
  const float lift_s = r.end_s + kReturnShiftDuration_s;
  r.walk_on_s = lift_s;
  r.home.idle_time_s = passing.time_s - kBeforePassing_s;
  const float walked_s = kBeforePassing_s + passing.until_landing_s;
  // The time in which the walk, which starts from a standstill, comes to where the foot lands.
  const float landing_s =
      walked_s < kWalkOn_s / 2 ? std::sqrt(2 * kWalkOn_s * walked_s) : walked_s + kWalkOn_s / 2;
  if (!is_idle(r)) r.arcs_back = motion::shorter_arcs(away, return_pose_at(r, r.end_s));
  r.idle_displacement = Eigen::Vector3f::Zero();
  r.idle_displacement =
      horizontal(away_foot(r, standing, lift_s).ankle - return_foot_at(r, standing, lift_s).ankle);
  free.return_step = {lift_s, lift_s + landing_s};
  free.return_lift_m = step_height(away_foot(r, motion::other(standing), lift_s),
                                   return_foot_at(r, motion::other(standing), lift_s + landing_s));
  r.return_duration_s = free.return_step.end_s + kPauseAfterSteps_s - r.end_s;
  r.feet[standing].return_step = {lift_s, r.end_s + r.return_duration_s};
  shift_weight(r, 1, standing, lift_s, r.end_s, r.end_s + r.return_duration_s);
}

// The feet's way home: one after the other, the one that carries more weight last.
void plan_return(Response& r) {
  const bool idles = is_idle(r);
  const motion::Pose away = idles ? source_pose_at(r, r.end_s) : clip_pose_at(r, r.end_s);
  const Side last = weight_bearing_foot(r, away);
  if (r.library->stance_of(r.home).loop.travels()) {
    plan_walking_on(r, away, last);
    return;
  }
  if (!idles) r.arcs_back = motion::shorter_arcs(away, return_pose_at(r, r.end_s));
  r.idle_displacement = Eigen::Vector3f::Zero();
  if (!idles) {
    r.idle_displacement = horizontal(away_foot(r, last, r.end_s + kMinBlend_s).ankle -
                                     return_foot_at(r, last, r.end_s + kMinBlend_s).ankle);
  }
  float time_s = r.end_s;
  for (Side side : {motion::other(last), last}) {
    FootPlan& plan = r.feet[side];
    const FootPose from = away_foot(r, side, time_s);
    const FootPose to = return_foot_at(r, side, time_s);
    if (!differ(from, to, kSamePosition_m, kSameYaw)) continue;
    const float lift_s = time_s + kReturnShiftDuration_s;
    plan.return_step = {lift_s, lift_s + kStepDuration_s};
    plan.return_lift_m = step_height(from, to);
    r.return_duration_s = plan.return_step.end_s + kPauseAfterSteps_s - r.end_s;
    time_s = plan.return_step.end_s;
  }
  r.return_duration_s = std::max(r.return_duration_s, idles ? kSettleDuration_s : kMinBlend_s);
  for (FootPlan& plan : r.feet) {
    if (plan.return_lift_m <= 0) plan.return_step = {r.end_s, r.end_s + r.return_duration_s};
  }
  std::size_t shift = 1;
  for (Side side : {motion::other(last), last}) {
    const FootPlan& plan = r.feet[side];
    if (plan.return_lift_m <= 0) continue;
    const float lift_s = plan.return_step.begin_s;
    shift_weight(r, shift++, motion::other(side), lift_s, lift_s - kReturnShiftDuration_s,
                 r.end_s + r.return_duration_s);
  }
}

bool is_usable(const RuledThreat& threat) {
  return features::is_usable(threat.threat) && threat.target_point.allFinite() &&
         velocity_at(threat.threat, threat.time_to_impact_s).norm() > 0.01F &&
         threat.delay_s >= 0 && threat.delay_s < threat.time_to_impact_s;
}

// The threat as it will be at the impact, on the straight line on which it then comes: the thesis
// keeps the values at the collision.
database::AimedThreat aimed(const RuledThreat& threat) {
  database::AimedThreat at_impact{threat.threat, threat.target_point};
  at_impact.threat.velocity = velocity_at(threat.threat, threat.time_to_impact_s);
  at_impact.threat.position =
      threat.target_point - threat.time_to_impact_s * at_impact.threat.velocity;
  return at_impact;
}

// Equation 4.1, as far as there is time.
void set_timing(const RuledThreat& threat, Response& r) {
  constexpr database::ThreatRange kRange;
  const Eigen::Vector3f velocity = aimed(threat).threat.velocity;
  const float speed =
      database::normalised(velocity.norm(), kRange.min_speed_mps, kRange.max_speed_mps);
  const Eigen::Vector3f facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), r.state.facing) * Eigen::Vector3f::UnitX();
  const float cosine = -facing.dot(velocity.normalized());
  r.begin_s = std::max(threat.time_to_impact_s - database::time_to_contact_s(speed, cosine),
                       threat.delay_s);
  r.peak_s = threat.time_to_impact_s;
  r.end_s = r.peak_s + database::kHold;
}

// Flat on the ground, below where they are.
motion::PerSide<FootPose> planted_feet(const Response& r, const motion::Pose& pose) {
  motion::PerSide<FootPose> feet;
  for (Side side : motion::kSides) {
    FootPose& foot = feet[side];
    foot = source_foot_in(r, side, pose);
    foot.ankle.z() = motion::measure_foot(r.library->skeleton(), side).ankle_height;
    foot.orientation =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  }
  return feet;
}

// The key poses start a little ahead in the motion, so that the body keeps its momentum.
void plan_brace(const RuledThreat& threat, Response& r) {
  const PreparedLibrary& library = *r.library;
  const motion::Figure figure{library.library->character, library.body_model};
  const database::AimedThreat at_impact = aimed(threat);
  const motion::Pose source = source_pose_at(r, r.begin_s);
  const motion::PerSide<FootPose> feet = planted_feet(r, source);
  r.brace.sustained =
      braced_pose(figure, source_pose_at(r, r.begin_s + database::kSustainedLookAhead), at_impact,
                  database::rule_controls(at_impact), feet);
  r.blend_duration_s = r.peak_s - r.begin_s;
  if (threat.startles && r.blend_duration_s > 2 * database::kStartle) {
    r.brace.startle_s = database::kStartle;
    r.blend_duration_s = database::kStartle;
    r.brace.startled = motion::with_feet(
        library.skeleton(),
        database::startle(figure, source_pose_at(r, r.begin_s + database::kStartleLookAhead),
                          at_impact),
        feet);
  }
  const Start start{source, clip_pose_at(r, r.begin_s)};
  for (Side side : motion::kSides) plan_foot(r, side, start);
  r.arcs_in = motion::shorter_arcs(start.source, start.clip);
  r.support = weight_bearing_foot(r, source);
  r.return_duration_s = database::kRecovery;
}

}  // namespace

Response make_brace(const PreparedLibrary& library, const features::CharacterState& state,
                    const RuledThreat& threat, const Inertialization& inertialization) noexcept {
  Response r;
  if (!is_usable_start(library, state, threat.time_to_impact_s, inertialization) ||
      !is_usable(threat)) {
    return r;
  }
  r.library = &library;
  r.clip = kNoClip;
  r.state = state;
  r.rest = state;
  r.home = state;
  r.inertialization = inertialization;
  set_timing(threat, r);
  const motion::Loop& stance = library.stance_of(state).loop;
  const bool walks = stance.travels() && inertialization.is_zero;
  if (walks) plan_leaving(r);
  plan_brace(threat, r);
  if (walks) r.home = features::later(stance, state, r.leave_s);
  plan_return(r);
  r.first_motion_s = walks ? r.leave_s : r.begin_s;
  return r;
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
  const bool walks = library.stance_of(state).loop.travels() && inertialization.is_zero;
  if (walks) {
    set_timing(annotation, time_to_impact_s, 0, r);
    plan_leaving(r);
  }
  plan_clip(annotation, time_to_impact_s, r.leave_s, r);
  const std::optional<float> lift_s = first_lift_s(r);
  if (lift_s && *lift_s - r.leave_s < kMinShiftDuration_s && !r.shifts[0].pelvis.isZero(0)) {
    // There is no time to shift the weight: the clip begins as much later.
    const float lead_s = (*lift_s - r.begin_s) * r.playback_rate / kMaxPlaybackRate;
    plan_clip(annotation, time_to_impact_s, r.leave_s + kMinShiftDuration_s - lead_s, r);
  }
  r.home = walks ? features::later(library.stance_of(state).loop, state, r.leave_s) : state;
  plan_return(r);
  r.first_motion_s = walks ? r.leave_s : std::min(r.begin_s, r.shifts[0].interval.begin_s);
  return r;
}

}  // namespace flinch::runtime
