// SPDX-License-Identifier: MIT
#include "runtime/response/foot_plan.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "runtime/response/leaving_plan.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

constexpr float kSamePlace_m = 2e-4F;        // above what the grid of clips moves a foot
constexpr float kSameYaw = 1e-3F;            // radians; the same
constexpr float kToleratedOffset_m = 0.04F;  // offset that a foot may keep during a clip
constexpr float kToleratedYaw = 0.15F;       // radians
constexpr float kQuickStep_s = 0.18F;        // of a step out of a stance
constexpr float kQuickStepHeight = 1.6F;     // of a slower step's

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

// Where the foot of a clip that has it elsewhere goes there. From a walk or a guard it may be far
// away: it arrives early in the swing. A walker steps as soon as the other foot stands, since its
// body goes on over that.
void plan_change(Response& r, Side side, const FootPose& from, const FootPose& to) {
  FootPlan& plan = r.feet[side];
  const bool is_far = differ(from, to, kToleratedOffset_m, kToleratedYaw);
  const bool idled = r.state.stance == 0;
  const std::optional<Interval> swing = first_swing(r, side);
  if (swing) plan.correction = *swing;
  if (swing && is_far && !idled)
    plan.correction.end_s = std::min(swing->end_s, swing->begin_s + kQuickStep_s);
  const bool must_step = side != r.support && is_far;
  if (must_step && !(swing && swing->begin_s < r.begin_s + r.blend_duration_s)) {
    const float begin_s = std::max(r.begin_s, ready_to_lift_s(r));
    if (swing && swing->begin_s < begin_s + kStepDuration_s)
      return;  // the clip's own comes soon enough
    plan.correction = {begin_s, begin_s + (idled ? kStepDuration_s : kQuickStep_s)};
    plan.correction_lift_m = (idled ? 1 : kQuickStepHeight) * step_height(from, to);
  }
}

// What a foot rolls over when it comes down flat: its ball if its heel is up, else its heel. A foot
// that is flat turns on its heel.
Eigen::Vector3f pivot_of(const motion::Skeleton& skeleton, Side side, const FootPose& foot) {
  constexpr float kFlat = 0.03F;  // sine of the angle to the ground
  const motion::FootDimensions dimensions = motion::measure_foot(skeleton, side);
  const float rise = (foot.orientation * dimensions.forward).z();
  return rise > -kFlat ? dimensions.heel : skeleton.offset[motion::roles_of(side).toes];
}

// The foot when it has come down flat over its pivot.
FootPose rolled_down(const FootPose& foot, const Eigen::Vector3f& pivot) {
  const Eigen::Quaternionf heading =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  return {foot.ankle + foot.orientation * pivot - heading * pivot, heading};
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
  if (r.state.stance != 0) plan.pivot = pivot_of(r.library->skeleton(), side, from);
  const FootPose stand = plan.pivot.isZero(0) ? from : rolled_down(from, plan.pivot);
  if (differ(stand, to, kSamePlace_m, kSameYaw)) {
    plan.offset.yaw = yaw_between(to, stand);
    plan.offset.translation = horizontal(
        stand.ankle - motion::rotation_about(Eigen::Vector3f::UnitZ(), plan.offset.yaw) * to.ankle);
  }
  plan_change(r, side, stand, to);
  const FootPose clip = clip_foot_in(r, side, start.clip, r.begin_s);
  plan.tilt = from.orientation * clip.orientation.conjugate();
  plan.rise = from.ankle - clip.ankle;
  if (!plan.pivot.isZero(0))
    plan.rise += from.orientation * plan.pivot - clip.orientation * plan.pivot;
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
