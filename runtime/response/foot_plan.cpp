// SPDX-License-Identifier: MIT
#include "runtime/response/foot_plan.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

constexpr float kToleratedOffset_m = 0.04F;  // offset that a foot may keep during a clip
constexpr float kToleratedYaw = 0.15F;       // radians

float yaw_between(const FootPose& from, const FootPose& to) {
  return motion::wrapped_to_pi(motion::yaw_of(to.orientation) - motion::yaw_of(from.orientation));
}

Interval response_interval(const Response& r, const Swing& swing) {
  const float onset_s = r.library->clip(r.clip).annotation->onset_s;
  return {r.begin_s + (swing.begin_s - onset_s) / r.playback_rate,
          r.begin_s + (swing.end_s - onset_s) / r.playback_rate};
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

}  // namespace

bool differ(const FootPose& a, const FootPose& b, float distance_m, float yaw) {
  return horizontal(a.ankle - b.ankle).norm() > distance_m || std::abs(yaw_between(b, a)) > yaw;
}

float step_height(const FootPose& from, const FootPose& to) {
  return std::clamp(0.25F * horizontal(to.ankle - from.ankle).norm(), 0.02F, 0.06F);
}

const Footwork& footwork_of(const Response& r) {
  static const Footwork kNone;
  if (r.clip == kNoClip) return kNone;
  return r.library->footwork[static_cast<std::size_t>(r.clip)];
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

}  // namespace flinch::runtime
