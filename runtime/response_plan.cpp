// SPDX-License-Identifier: MIT
// Plans responses: when the clip plays, where the feet go and how the weight is shifted.
#include <algorithm>
#include <array>
#include <cmath>

#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "runtime/response.h"
#include "runtime/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::FootPlace;
using motion::Role;
using motion::Side;

constexpr float kShift = 0.3F;        // s, that a shift of weight takes where there is time
constexpr float kLeastShift = 0.15F;  // s, that it takes at least
constexpr float kShiftHome = 0.4F;    // s, before a step home
constexpr float kUnshift = 0.45F;     // s, back
constexpr float kHeldBefore = 0.04F;  // s, that it is there before a foot leaves the ground
constexpr float kHeldAfter = 0.025F;  // s, and stays after
constexpr float kStep = 0.25F;        // s, that a step takes that no clip has
constexpr float kCalm = 0.1F;         // s, after the last step home
constexpr float kSettle = 0.6F;       // s, from another motion to idle
constexpr float kSame = 1e-3F;        // m, by which a foot may be elsewhere without a step
constexpr float kSameYaw = 3e-3F;     // radians
constexpr float kKept = 0.04F;        // m, by which a foot may stand elsewhere during a clip
constexpr float kKeptYaw = 0.15F;     // radians

bool is_finite(const features::CharacterState& state) {
  return std::isfinite(state.idle_time_s) && state.position.allFinite() &&
         std::isfinite(state.facing);
}

bool is_finite(const Origin& origin) {
  if (origin.idles) return true;
  bool finite = origin.root.allFinite() && origin.root_velocity.allFinite();
  for (motion::Role role : motion::kRoles) {
    finite = finite && origin.turn[role].allFinite() && origin.turn_velocity[role].allFinite();
  }
  for (const FootPlace& foot : origin.foot) {
    finite = finite && foot.ankle.allFinite() && foot.orientation.coeffs().allFinite();
  }
  return finite;
}

bool has_clip(const database::Library& library, int clip) {
  return clip >= 0 && static_cast<std::size_t>(clip) < library.clips.size() &&
         !library.clips[static_cast<std::size_t>(clip)].motion.poses.empty();
}

bool is_in_order(const motion::Annotation& annotation) {
  return annotation.onset_s >= 0 && annotation.onset_s < annotation.peak_s &&
         annotation.peak_s <= annotation.end_s && std::isfinite(annotation.end_s);
}

bool can_use(const PreparedLibrary& prepared, const features::CharacterState& state, int clip,
             float time_to_impact_s, const Origin& origin) {
  if (prepared.library == nullptr) return false;
  const database::Library& library = *prepared.library;
  if (!has_clip(library, library.idle) || !has_clip(library, clip)) return false;
  if (!is_finite(state) || !is_finite(origin)) return false;
  if (!(time_to_impact_s > 0) || !std::isfinite(time_to_impact_s)) return false;
  const auto& annotation = library.clips[static_cast<std::size_t>(clip)].annotation;
  return clip == library.idle || (annotation && is_in_order(*annotation));
}

float turn_between(const FootPlace& from, const FootPlace& to) {
  return motion::wrapped(motion::yaw_of(to.orientation) - motion::yaw_of(from.orientation));
}

bool differ(const FootPlace& a, const FootPlace& b, float distance_m, float yaw) {
  return level(a.ankle - b.ankle).norm() > distance_m || std::abs(turn_between(b, a)) > yaw;
}

float lift_of(const FootPlace& from, const FootPlace& to) {
  return std::clamp(0.25F * level(to.ankle - from.ankle).norm(), 0.02F, 0.06F);
}

// With d from onset to peak and b the earliest begin: rate = clamp(d / (T - b), 1, most) and
// begin = max(b, T - d / rate).
void set_timing(const motion::Annotation& annotation, float time_to_impact_s, float earliest_s,
                Response& r) {
  const float onset_to_peak_s = annotation.peak_s - annotation.onset_s;
  const float left_s = time_to_impact_s - earliest_s;
  r.playback_rate = left_s > 0 ? std::clamp(onset_to_peak_s / left_s, 1.0F, kMostPlaybackRate)
                               : kMostPlaybackRate;
  const float way_to_peak_s = onset_to_peak_s / r.playback_rate;
  r.begin_s = std::max(earliest_s, time_to_impact_s - way_to_peak_s);
  r.blend_s = std::min(kBlend, way_to_peak_s);
  r.peak_s = r.begin_s + way_to_peak_s;
  r.end_s = r.begin_s + (annotation.end_s - annotation.onset_s) / r.playback_rate;
}

// What is blended when the clip begins.
struct Start {
  motion::Pose source;
  motion::Pose clip;
};

// Lays the clip's support foot on the character's.
Start align(Response& r) {
  r.yaw = r.state.facing;
  r.translation = Eigen::Vector3f::Zero();
  Start start{source_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s)};
  r.translation = level(source_foot_in(r, r.support, start.source).ankle -
                        foot_of(r.library->skeleton(), start.clip, r.support).ankle);
  start.clip.root_position += r.translation;
  return start;
}

Window in_response(const Response& r, const Swing& swing) {
  const float onset_s = r.library->clip(r.clip).annotation->onset_s;
  return {r.begin_s + (swing.begin_s - onset_s) / r.playback_rate,
          r.begin_s + (swing.end_s - onset_s) / r.playback_rate};
}

const Footwork& footwork_of(const Response& r) {
  return r.library->footwork[static_cast<std::size_t>(r.clip)];
}

// The first swing of a foot by which it can go to where the clip has it.
std::optional<Window> first_swing(const Response& r, Side side) {
  const std::vector<Swing>& swings = footwork_of(r).swings[motion::index_of(side)];
  if (swings.empty()) return std::nullopt;
  const Window window = in_response(r, swings.front());
  if (window.begin_s >= r.end_s) return std::nullopt;
  return window;
}

// Where the foot of a clip that has it elsewhere goes there.
void plan_change(Response& r, Side side, const FootPlace& from, const FootPlace& to) {
  FootPlan& plan = r.feet[motion::index_of(side)];
  const std::optional<Window> swing = first_swing(r, side);
  if (swing) plan.change = *swing;
  const bool must_step = side != r.support && differ(from, to, kKept, kKeptYaw);
  if (must_step && !(swing && swing->begin_s < r.begin_s + r.blend_s)) {
    const float begin_s = std::max(r.begin_s, kLeastShift);
    if (swing && swing->begin_s < begin_s + kStep) return;  // the clip's own comes soon enough
    plan.change = {begin_s, begin_s + kStep};
    plan.change_lift_m = lift_of(from, to);
  }
}

void plan_foot(Response& r, Side side, const Start& start) {
  FootPlan& plan = r.feet[motion::index_of(side)];
  plan = {};
  const FootPlace from = source_foot_in(r, side, start.source);
  const FootPlace to = foot_of(r.library->skeleton(), start.clip, side);
  if (differ(from, to, 1e-5F, 1e-4F)) {
    plan.offset.yaw = turn_between(to, from);
    plan.offset.translation = level(
        from.ankle - motion::turn_about(Eigen::Vector3f::UnitZ(), plan.offset.yaw) * to.ankle);
  }
  plan_change(r, side, from, to);
  const FootPlace clip = clip_foot_in(r, side, start.clip, r.begin_s);
  plan.rise = from.ankle - clip.ankle;
  plan.tilt = from.orientation * clip.orientation.conjugate();
}

// How far a point is from being kMargin inside of a sole, on the way to the sole's middle.
Eigen::Vector2f lacking_to_sole(const Sole& sole, const Eigen::Vector2f& point) {
  constexpr float kMargin = 0.015F;  // m
  const Eigen::Vector2f inward = sole.middle - point;
  if (motion::is_inside_by(kMargin - 1e-4F, sole.hull, point)) return {0, 0};
  float outside = 0;
  float inside = 1;
  for (int k = 0; k < 12; ++k) {
    const float half = 0.5F * (outside + inside);
    const bool is_inside = motion::is_inside_by(kMargin, sole.hull, point + half * inward);
    (is_inside ? inside : outside) = half;
  }
  return inside * inward;
}

// Finds the pelvis' way of a shift, one of the response's, that brings the centre of mass over the
// sole of a foot. A pelvis takes most of the body along; the feet stay, so it must go a little
// farther.
void bring_over(const Response& r, Side side, float lift_s, WeightShift& shift) {
  constexpr float kAlong = 1.17F;
  constexpr float kDip = 0.2F;         // knees give, and need not straighten suddenly
  constexpr float kMostSpeed = 1.35F;  // m/s, mean: what is lacking then is left to momentum
  constexpr int kRounds = 6;
  const PreparedLibrary& library = *r.library;
  const float most_m = kMostSpeed * (shift.held.begin_s - shift.window.begin_s);
  shift.pelvis = Eigen::Vector3f::Zero();
  const Samples samples = samples_at(r, lift_s);
  const motion::Pose unshifted = blended(r, samples);
  const Legs legs = legs_of(r, samples, unshifted);
  for (int round = 0; round < kRounds; ++round) {
    motion::Pose pose = unshifted;
    const Eigen::Vector3f weight_shift = weight_shift_at(r, lift_s);
    if (must_place_feet(r, samples, weight_shift)) place_feet(r, legs, weight_shift, pose);
    const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), pose);
    const FootPlace foot = motion::foot_place(frames, side);
    const Eigen::Quaternionf heading =
        motion::turn_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
    const Eigen::Vector3f centre = motion::centre_of_mass(library.bodies, frames);
    const Eigen::Vector2f in_sole = (heading.conjugate() * level(centre - foot.ankle)).head<2>();
    const Eigen::Vector2f lacking = lacking_to_sole(library.soles[motion::index_of(side)], in_sole);
    if (lacking.norm() <= 0) break;
    shift.pelvis += kAlong * (heading * Eigen::Vector3f(lacking.x(), lacking.y(), 0));
    const float distance = level(shift.pelvis).norm();
    if (distance > most_m) shift.pelvis *= most_m / distance;
    shift.pelvis.z() = -kDip * level(shift.pelvis).norm();
  }
}

// Shifts the weight over a foot, from `begin_s` on, before the other leaves the ground at `lift_s`.
void shift_weight(Response& r, std::size_t number, Side over, float lift_s, float begin_s,
                  float latest_s) {
  WeightShift& shift = r.shifts[number];
  shift.held = {lift_s - kHeldBefore, lift_s + kHeldAfter};
  shift.window = {begin_s, std::min(lift_s + kUnshift, latest_s)};
  bring_over(r, over, lift_s, shift);
  if (shift.pelvis.isZero(0)) shift = {};
}

// When the other foot first leaves the ground, if it does before the clip's peak.
std::optional<float> first_lift_s(const Response& r) {
  const Side other = motion::other(r.support);
  const FootPlan& plan = r.feet[motion::index_of(other)];
  std::optional<float> lift_s;
  if (plan.change_lift_m > 0) lift_s = plan.change.begin_s;
  const std::optional<Window> swing = first_swing(r, other);
  if (swing && (!lift_s || swing->begin_s < *lift_s)) lift_s = swing->begin_s;
  if (lift_s && *lift_s >= r.peak_s && plan.change_lift_m <= 0) return std::nullopt;
  return lift_s;
}

/// Joints whose velocities are compared, and all that their poses need: a stage of pose_at alone
/// where that will do, for they are asked for at many times.
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
float most_difference(const Eigen::Quaternionf& first, const Eigen::Quaternionf& second) {
  constexpr float kSmall = 1.0F / 16;
  constexpr float kRounding = 1e-6F;
  if (!(first.vec().squaredNorm() < kSmall && second.vec().squaredNorm() < kSmall))
    return std::numeric_limits<float>::infinity();
  return 2.08F * (second.vec() - first.vec()).norm() + kRounding;
}

/// The joint whose velocity changes most, and by how much.
struct Change {
  float most = 0;  // rad a frame
  Role role = Role::pelvis;
};

// The most by which the velocity of one of these joints changes from the first two poses to the
// last two, or `change` where that is more. Most joints need not be looked at closely.
Change most_change(const std::array<motion::Pose, 3>& poses, std::span<const Role> roles,
                   Change change) {
  for (Role role : roles) {
    const Eigen::Quaternionf first = turn_of(role, poses[0], poses[1]);
    const Eigen::Quaternionf second = turn_of(role, poses[1], poses[2]);
    if (most_difference(first, second) < change.most) continue;
    const float here = (motion::rotation_vector(second) - motion::rotation_vector(first)).norm();
    if (here > change.most) change = {here, role};
  }
  return change;
}

constexpr float kFrame = 1.0F / 60;  // s

motion::Pose pose_of(const Response& r, float time_s, const Group& group) {
  const Samples samples = samples_at(r, time_s, group.needed);
  motion::Pose pose = blended(r, samples, group.needed);
  if (!group.is_placed) return pose;
  const Eigen::Vector3f shift = weight_shift_at(r, time_s);
  if (must_place_feet(r, samples, shift)) place_feet(r, legs_of(r, samples, pose), shift, pose);
  return pose;
}

// The most by which a joint's velocity changes about a time, from one frame to the next. Stops at a
// change above `enough`: where that is likely to come, at `suspect`, it looks first.
Change change_at(const Response& r, float time_s, const std::optional<Role>& suspect,
                 float enough) {
  constexpr Group kOfLegs{kLegs, kLegsAndToes, true};
  constexpr Group kOfOthers{kOthers, kOthers, false};
  std::array groups{kOfOthers, kOfOthers, kOfLegs};
  auto to_look_at = std::span(groups).last(2);
  if (suspect && is_of_legs(*suspect)) {
    std::swap(groups[1], groups[2]);
  } else if (suspect) {
    groups[0] = {{&*suspect, 1}, {&*suspect, 1}, false};
    to_look_at = groups;
  }
  Change change;
  for (const Group& group : to_look_at) {
    change = most_change({pose_of(r, time_s - kFrame, group), pose_of(r, time_s, group),
                          pose_of(r, time_s + kFrame, group)},
                         group.compared, change);
    if (change.most / kFrame > enough) break;
  }
  return change;
}

// What is left of a blend adds to what the clip does: of the ends that it may have, the blend takes
// the one where the motion is calmest, of equals the first. Those that are the calmest most often
// are tried first, and the others left as soon as they are seen not to be.
void end_blend(Response& r) {
  constexpr std::array kLonger{0.06F, 0.08F, 0.0F, 0.02F, 0.04F};  // s
  Response tried = r;
  std::optional<Role> suspect;
  float least = std::numeric_limits<float>::infinity();
  for (float longer_s : kLonger) {
    tried.blend_s = kBlend + longer_s;
    if (tried.blend_s > r.peak_s - r.begin_s) continue;
    const Change change = change_at(tried, tried.begin_s + tried.blend_s, suspect, least);
    suspect = change.role;
    const float step = change.most / kFrame;
    if (step < least || (step == least && tried.blend_s < r.blend_s)) {
      least = step;
      r.blend_s = tried.blend_s;
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
    shift_weight(r, 0, r.support, *lift_s, std::max(*lift_s - kShift, 0.0F), r.end_s);
  };
  if (lift_s) shift();
  end_blend(r);
  const bool is_lifted_meanwhile = lift_s && *lift_s < r.begin_s + r.blend_s;
  if (is_lifted_meanwhile) shift();
}

// The foot that carries more weight in the pose where the way home begins.
Side foot_that_carries(const Response& r, const motion::Pose& away) {
  constexpr float kClearly = 0.02F;  // m, by which the other must be nearer
  const PreparedLibrary& library = *r.library;
  const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), away);
  const Eigen::Vector3f centre = motion::centre_of_mass(library.bodies, frames);
  const auto distance = [&](Side side) {
    return level(motion::foot_place(frames, side).ankle - centre).norm();
  };
  const Side other = motion::other(r.support);
  return distance(other) < distance(r.support) - kClearly ? other : r.support;
}

// The feet's way home: one after the other, the one that carries more weight last.
void plan_return(Response& r) {
  const bool idles = r.clip == r.library->library->idle;
  const motion::Pose away = idles ? source_pose_at(r, r.end_s) : clip_pose_at(r, r.end_s);
  const Side last = foot_that_carries(r, away);
  if (!idles) r.arcs_back = motion::shorter_arcs(away, home_pose_at(r, r.end_s));
  const auto away_foot = [&](Side side, float time_s) {
    return idles ? source_foot_at(r, side, time_s) : clip_foot_at(r, side, time_s);
  };
  r.travel = Eigen::Vector3f::Zero();
  if (!idles) {
    r.travel = level(away_foot(last, r.end_s + kBlend).ankle -
                     home_foot_at(r, last, r.end_s + kBlend).ankle);
  }
  float time_s = r.end_s;
  for (Side side : {motion::other(last), last}) {
    FootPlan& plan = r.feet[motion::index_of(side)];
    const FootPlace from = away_foot(side, time_s);
    const FootPlace to = home_foot_at(r, side, time_s);
    if (!differ(from, to, kSame, kSameYaw)) continue;
    const float lift_s = time_s + kShiftHome;
    plan.home = {lift_s, lift_s + kStep};
    plan.home_lift_m = lift_of(from, to);
    r.return_s = plan.home.end_s + kCalm - r.end_s;
    time_s = plan.home.end_s;
  }
  r.return_s = std::max(r.return_s, idles ? kSettle : kBlend);
  for (FootPlan& plan : r.feet) {
    if (plan.home_lift_m <= 0) plan.home = {r.end_s, r.end_s + r.return_s};
  }
  std::size_t shift = 1;
  for (Side side : {motion::other(last), last}) {
    const FootPlan& plan = r.feet[motion::index_of(side)];
    if (plan.home_lift_m <= 0) continue;
    const float lift_s = plan.home.begin_s;
    shift_weight(r, shift++, motion::other(side), lift_s, lift_s - kShiftHome,
                 r.end_s + r.return_s);
  }
}

}  // namespace

Response make_response(const PreparedLibrary& library, const features::CharacterState& state,
                       int clip, float time_to_impact_s, const Origin& origin) noexcept {
  Response r;
  if (!can_use(library, state, clip, time_to_impact_s, origin)) return r;
  r.library = &library;
  r.clip = clip;
  r.state = state;
  r.origin = origin;
  r.support = footwork_of(r).support;
  if (clip == library.library->idle) {
    if (!origin.idles) plan_return(r);
    return r;
  }
  const motion::Annotation& annotation = *library.clip(clip).annotation;
  plan_clip(annotation, time_to_impact_s, 0, r);
  const std::optional<float> lift_s = first_lift_s(r);
  if (lift_s && *lift_s < kLeastShift && !r.shifts[0].pelvis.isZero(0)) {
    // There is no time to shift the weight: the clip begins as much later.
    const float lead_s = (*lift_s - r.begin_s) * r.playback_rate / kMostPlaybackRate;
    plan_clip(annotation, time_to_impact_s, kLeastShift - lead_s, r);
  }
  plan_return(r);
  r.start_s = std::min(r.begin_s, r.shifts[0].window.begin_s);
  return r;
}

}  // namespace flinch::runtime
