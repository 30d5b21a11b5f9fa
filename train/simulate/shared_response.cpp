// SPDX-License-Identifier: MIT
#include "train/simulate/shared_response.h"

#include <algorithm>
#include <cmath>

namespace flinch::train {

namespace {

// Far above the effect of rounding on a plan, far below anything visible.
constexpr float kSameTime = 1e-5F;   // s
constexpr float kSamePlace = 1e-4F;  // m, radians
// Above what plans take for the same place of a foot (runtime/response/foot_plan.cpp), and so for
// no offset at all.
constexpr float kSameFoot_m = 3e-4F;
constexpr float kSameFootYaw = 1.5e-3F;

bool is_near(float a, float b, float tolerance) {
  // Equality covers events that never happen, at infinity.
  return a == b || std::abs(a - b) <= tolerance;
}

bool is_near(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return (a - b).norm() <= kSamePlace;
}

bool is_near(const runtime::Interval& a, float a_impact_s, const runtime::Interval& b,
             float b_impact_s) {
  return is_near(a.begin_s - a_impact_s, b.begin_s - b_impact_s, kSameTime) &&
         is_near(a.end_s - a_impact_s, b.end_s - b_impact_s, kSameTime);
}

bool is_near(const runtime::FootPlan& a, float a_impact_s, const runtime::FootPlan& b,
             float b_impact_s) {
  return is_near(a.offset.yaw, b.offset.yaw, kSameFootYaw) &&
         (a.offset.translation - b.offset.translation).norm() <= kSameFoot_m &&
         is_near(a.correction, a_impact_s, b.correction, b_impact_s) &&
         is_near(a.correction_lift_m, b.correction_lift_m, kSamePlace) &&
         is_near(a.return_step, a_impact_s, b.return_step, b_impact_s) &&
         is_near(a.return_lift_m, b.return_lift_m, kSamePlace);
}

bool is_near(const runtime::WeightShift& a, float a_impact_s, const runtime::WeightShift& b,
             float b_impact_s) {
  return is_near(a.interval, a_impact_s, b.interval, b_impact_s) &&
         is_near(a.hold, a_impact_s, b.hold, b_impact_s) && is_near(a.pelvis, b.pelvis);
}

bool is_near(const runtime::Landing& a, float a_impact_s, const runtime::Landing& b,
             float b_impact_s) {
  return is_near(a.interval, a_impact_s, b.interval, b_impact_s) && is_near(a.way, b.way) &&
         is_near(a.velocity, b.velocity);
}

bool is_near(const features::CharacterState& a, const features::CharacterState& b) {
  return (a.position - b.position).norm() <= kSamePlace && is_near(a.facing, b.facing, kSamePlace);
}

/// The same of leaving a stance that travels.
bool leaves_alike(const runtime::Response& a, float a_impact_s, const runtime::Response& b,
                  float b_impact_s) {
  bool same = is_near(a.leave_s - a_impact_s, b.leave_s - b_impact_s, kSameTime) &&
              is_near(a.walk_on_s - a_impact_s, b.walk_on_s - b_impact_s, kSameTime) &&
              is_near(a.rest, b.rest) && is_near(a.home, b.home);
  for (const motion::Side side : motion::kSides)
    same = same && is_near(a.landings[side], a_impact_s, b.landings[side], b_impact_s);
  return same;
}

}  // namespace

bool is_same_from_impact(const runtime::Response& early, float early_time_s,
                         const runtime::Response& late, float late_time_s) {
  if (is_idle(early)) return is_idle(late);
  const auto at_same_time = [&](float a_s, float b_s) {
    return is_near(a_s - early_time_s, b_s - late_time_s, kSameTime);
  };
  bool same = early.clip == late.clip && early.support == late.support &&
              at_same_time(early.first_motion_s, late.first_motion_s) &&
              at_same_time(early.begin_s, late.begin_s) &&
              at_same_time(early.peak_s, late.peak_s) && at_same_time(early.end_s, late.end_s) &&
              is_near(early.playback_rate, late.playback_rate, kSameTime) &&
              is_near(early.blend_duration_s, late.blend_duration_s, kSameTime) &&
              is_near(early.return_duration_s, late.return_duration_s, kSameTime) &&
              is_near(early.yaw, late.yaw, kSamePlace) &&
              is_near(early.translation, late.translation) &&
              is_near(early.idle_displacement, late.idle_displacement) &&
              (late.walk_on_s < 0 || leaves_alike(early, early_time_s, late, late_time_s));
  for (const motion::Side side : motion::kSides)
    same = same && is_near(early.feet[side], early_time_s, late.feet[side], late_time_s);
  for (std::size_t i = 0; i < early.shifts.size(); ++i)
    same = same && is_near(early.shifts[i], early_time_s, late.shifts[i], late_time_s);
  return same;
}

namespace {

/// Returns the first time to impact from which on the clip's response is the same, or a negative
/// number if there is no response. Once the same, it stays the same, because of how responses are
/// planned: a bound that more time has loosened stays loose.
int first_shared_time(const runtime::PreparedLibrary& library,
                      const ScenarioDistribution& distribution, int clip, int state) {
  const std::vector<motion::Loop> stances = stance_loops(*library.library);
  const auto response_to = [&](int time) {
    return runtime::make_response(library, character_state_at(distribution, stances, {state, time}),
                                  clip, time_to_impact_s(distribution, time));
  };
  int max_time = time_to_impact_count(distribution) - 1;
  const runtime::Response longest = response_to(max_time);
  if (!runtime::is_valid(longest)) return -1;
  const float longest_s = time_to_impact_s(distribution, max_time);
  int min_time = 0;
  while (min_time < max_time) {
    const int middle = (min_time + max_time) / 2;
    const bool same = is_same_from_impact(
        response_to(middle), time_to_impact_s(distribution, middle), longest, longest_s);
    (same ? max_time : min_time) = same ? middle : middle + 1;
  }
  return min_time;
}

}  // namespace

SharedResponses::SharedResponses(const runtime::PreparedLibrary& library,
                                 const ScenarioDistribution& distribution)
    : state_count_(state_count(distribution)) {
  const auto clips = static_cast<int>(library.library->clips.size());
  for (int clip = 0; clip < clips; ++clip) {
    for (int state = 0; state < state_count_; ++state)
      first_shared_time_.push_back(first_shared_time(library, distribution, clip, state));
  }
}

std::size_t SharedResponses::index(int clip, int state) const {
  return static_cast<std::size_t>(clip * state_count_ + state);
}

ResponseKey SharedResponses::key_of(int clip, GridCell cell) const {
  const int first_time = first_shared_time_[index(clip, cell.state)];
  return {clip, {cell.state, std::min(cell.time, first_time)}};
}

std::size_t SharedResponses::count() const {
  std::size_t count = 0;
  for (const int first_time : first_shared_time_) count += static_cast<std::size_t>(first_time + 1);
  return count;
}

std::size_t SharedResponses::count_at(int time) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      first_shared_time_, [time](int first_time) { return first_time >= time; }));
}

}  // namespace flinch::train
