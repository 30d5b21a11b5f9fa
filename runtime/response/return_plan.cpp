// SPDX-License-Identifier: MIT
#include "runtime/response/return_plan.h"

#include <algorithm>
#include <cmath>

#include "runtime/response/foot_plan.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"
#include "runtime/response/weight_shift.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

constexpr float kReturnShiftDuration_s = 0.4F;  // of the shift before a step on the way back
constexpr float kPauseAfterSteps_s = 0.1F;      // after the last step on the way back
constexpr float kSettleDuration_s = 0.6F;       // from another motion to idle
constexpr float kBeforePassing_s = 0.05F;       // of a walk: where it begins anew
constexpr float kSamePosition_m = 1e-3F;        // offset of a foot that needs no step
constexpr float kSameYaw = 3e-3F;               // radians

// A foot where the way home begins, or after it.
FootPose away_foot(const Response& r, Side side, float time_s) {
  return is_idle(r) ? source_foot_at(r, side, time_s) : clip_foot_at(r, side, time_s);
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

}  // namespace

Side weight_bearing_foot(const Response& r, const motion::Pose& pose) {
  constexpr float kClearlyNearer_m = 0.02F;  // m, by which the other must be nearer
  const PreparedLibrary& library = *r.library;
  const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), pose);
  const Eigen::Vector3f centre = motion::centre_of_mass(library.body_model, frames);
  const auto distance = [&](Side side) {
    return horizontal(motion::foot_pose(frames, side).ankle - centre).norm();
  };
  const Side other = motion::other(r.support);
  return distance(other) < distance(r.support) - kClearlyNearer_m ? other : r.support;
}

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

}  // namespace flinch::runtime
