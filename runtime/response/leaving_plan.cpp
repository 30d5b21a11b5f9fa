// SPDX-License-Identifier: MIT
#include "runtime/response/leaving_plan.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;

constexpr float kStandstill_s = 0.15F;     // from leaving a walk to the clip
constexpr float kMinLanding_s = 0.1F;      // of a foot that swings
constexpr float kMaxLanding_s = 0.22F;     // the same
constexpr float kInterval_s = 1.0F / 240;  // over which velocities are measured

/// A walk at two moments.
struct Moment {
  JointFrames before;
  JointFrames now;
};

// A foot stands on a point of its sole that is near the ground and does not move along it.
bool stands(const PreparedLibrary& library, const Moment& moment, Side side) {
  constexpr float kMaxHeight_m = 0.02F;
  constexpr float kMaxSpeed_mps = 0.4F;
  const motion::FootRoles roles = motion::roles_of(side);
  const auto is_still = [&](Role role, const Eigen::Vector3f& point) {
    const auto at = [&](const JointFrames& frames) -> Eigen::Vector3f {
      return frames.position[role] + frames.orientation[role] * point;
    };
    const Eigen::Vector3f now = at(moment.now);
    return now.z() < kMaxHeight_m &&
           horizontal(now - at(moment.before)).norm() < kMaxSpeed_mps * kInterval_s;
  };
  const Sole& sole = library.soles[side];
  return std::ranges::any_of(sole.foot, [&](const auto& p) { return is_still(roles.foot, p); }) ||
         std::ranges::any_of(sole.toes, [&](const auto& p) { return is_still(roles.toes, p); });
}

// Flat on the ground, below where it is.
FootPose flat(const motion::Skeleton& skeleton, Side side, FootPose foot) {
  foot.ankle.z() = motion::measure_foot(skeleton, side).ankle_height;
  foot.orientation =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  return foot;
}

// A foot of the walk some time after it was left.
FootPose walking_foot(const Response& r, Side side, float after_s) {
  const motion::Loop& walk = r.library->stance_of(r.state).loop;
  return foot_of(r.library->skeleton(),
                 features::idle_pose(walk, r.state, r.leave_s + after_s, leg_chain(side)), side);
}

// When a foot that swings lands if the walk goes on, as far as a response has time for that.
float time_to_landing_s(const Response& r, Side side) {
  constexpr float kStep_s = 1.0F / 60;
  const motion::Skeleton& skeleton = r.library->skeleton();
  const float ankle_height = motion::measure_foot(skeleton, side).ankle_height;
  float time_s = kMinLanding_s;
  while (time_s < kMaxLanding_s &&
         walking_foot(r, side, time_s).ankle.z() > ankle_height + kMaxStandingHeight_m)
    time_s += kStep_s;
  return std::min(time_s, kMaxLanding_s);
}

void set_stand(Response& r, Side side, const FootPose& stand, float duration_s) {
  const FootPose now = walking_foot(r, side, 0);
  const FootPose before = walking_foot(r, side, -kInterval_s);
  r.inertialization.stands[side] = true;
  r.inertialization.foot[side] = stand;
  r.landings[side] = {{r.leave_s, r.leave_s + duration_s},
                      now.ankle - stand.ankle,
                      (now.ankle - before.ankle) / kInterval_s,
                      now.orientation * stand.orientation.conjugate()};
}

// Whether the clip lifts the foot that is not its support before its peak.
bool needs_its_support(const Response& r) {
  if (r.clip == kNoClip) return false;
  const std::vector<Swing>& swings = footwork_of(r).swings[motion::other(r.support)];
  return !swings.empty() && swings.front().begin_s < r.library->clip(r.clip).annotation->peak_s;
}

// The foot in front, on which a walker comes to rest.
Side front_foot(const Moment& moment, const motion::PerSide<bool>& stands) {
  const Eigen::Vector3f velocity =
      moment.now.position[Role::pelvis] - moment.before.position[Role::pelvis];
  const Eigen::Vector3f left_from_right = motion::foot_pose(moment.now, Side::left).ankle -
                                          motion::foot_pose(moment.now, Side::right).ankle;
  const float ahead_m = horizontal(velocity).normalized().dot(left_from_right);
  constexpr float kClearly_m = 0.05F;  // a foot that swings must be ahead
  const Side front = ahead_m > 0 ? Side::left : Side::right;
  if (stands[front] || !stands[motion::other(front)]) return front;
  return std::abs(ahead_m) > kClearly_m ? front : motion::other(front);
}

// Where the body stops if its velocity decays as a difference does that has no other
// (Inertialization).
Eigen::Vector3f stopping_place(const Moment& moment) {
  const Eigen::Vector3f& now = moment.now.position[Role::pelvis];
  return now + (now - moment.before.position[Role::pelvis]) / (kInterval_s * kDecayRate);
}

// A foot that swings far ahead of where the body stops takes a shorter step.
FootPose stopping_step(const Moment& moment, FootPose foot) {
  constexpr float kMaxAhead_m = 0.12F;
  const Eigen::Vector3f stop = stopping_place(moment);
  const Eigen::Vector3f way = horizontal(stop - moment.before.position[Role::pelvis]).normalized();
  const float ahead_m = way.dot(foot.ankle - stop);
  foot.ankle -= std::max(ahead_m - kMaxAhead_m, 0.0F) * way;
  return foot;
}

// The body comes to rest where it stops: not over its feet, which stand where they are.
features::CharacterState resting_at(const Response& r, const Eigen::Vector3f& stop, float facing) {
  features::CharacterState rest;
  rest.stance = r.state.stance;
  rest.facing = facing;
  const Pose& idle = r.library->rest_of(rest).loop.motion().poses.front();
  const Eigen::Quaternionf turn = motion::rotation_about(Eigen::Vector3f::UnitZ(), facing);
  rest.position = (stop - turn * idle.root_position).head<2>();
  return rest;
}

}  // namespace

bool walks(const PreparedLibrary& library, const features::CharacterState& state,
           const Inertialization& inertialization) {
  return library.stance_of(state).loop.travels() && inertialization.is_zero;
}

void plan_leaving(Response& r) {
  const PreparedLibrary& library = *r.library;
  r.leave_s = std::max(r.begin_s - kStandstill_s, 0.0F);
  const motion::Loop& walk = library.stance_of(r.state).loop;
  const Pose now = features::idle_pose(walk, r.state, r.leave_s);
  const Pose before = features::idle_pose(walk, r.state, r.leave_s - kInterval_s);
  const Moment moment{motion::forward_kinematics(library.skeleton(), before),
                      motion::forward_kinematics(library.skeleton(), now)};
  motion::PerSide<bool> standing;
  motion::PerSide<FootPose> stand;
  motion::PerSide<float> landing_s;
  for (Side side : motion::kSides) {
    standing[side] = stands(library, moment, side);
    stand[side] = motion::foot_pose(moment.now, side);
    if (standing[side]) continue;
    landing_s[side] = time_to_landing_s(r, side);
    stand[side] = flat(library.skeleton(), side,
                       stopping_step(moment, walking_foot(r, side, landing_s[side])));
  }
  const Side front = front_foot(moment, standing);
  if (!needs_its_support(r)) r.support = front;
  r.goes_on_over_support = r.support == front;
  r.rest = resting_at(r, stopping_place(moment), features::later(walk, r.state, r.leave_s).facing);
  r.inertialization = make_inertialization(library, r.rest, before, now, kInterval_s);
  for (Side side : motion::kSides) {
    r.inertialization.stands[side] = true;
    if (!standing[side]) set_stand(r, side, stand[side], landing_s[side]);
  }
}

void land_beside(Response& r, const Start& start) {
  const Side side = motion::other(r.support);
  if (!std::isfinite(r.landings[side].interval.end_s)) return;
  const motion::Skeleton& skeleton = r.library->skeleton();
  set_stand(r, side, flat(skeleton, side, foot_of(skeleton, start.clip, side)), kMaxLanding_s);
}

float ready_to_lift_s(const Response& r) {
  const Landing& landing = r.landings[r.support];
  const bool lands = std::isfinite(landing.interval.end_s);
  const float shifted_s = r.leave_s + (r.goes_on_over_support ? 0 : kMinShiftDuration_s);
  return lands ? std::max(shifted_s, landing.interval.end_s) : shifted_s;
}

}  // namespace flinch::runtime
