// SPDX-License-Identifier: MIT
#include "train/simulate/shared_response.h"

#include <algorithm>
#include <cmath>

namespace flinch::train {

namespace {

// Far above what the rounding of floats does to a plan, far below what shows.
constexpr float kSameTime = 1e-5F;   // s
constexpr float kSamePlace = 1e-4F;  // m, radians

bool near(float a, float b, float tolerance) {
  return a == b || std::abs(a - b) <= tolerance;  // the first for what never happens, at infinity
}

bool near(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return (a - b).norm() <= kSamePlace;
}

bool near(const runtime::Window& a, float a_impact_s, const runtime::Window& b, float b_impact_s) {
  return near(a.begin_s - a_impact_s, b.begin_s - b_impact_s, kSameTime) &&
         near(a.end_s - a_impact_s, b.end_s - b_impact_s, kSameTime);
}

bool near(const runtime::FootPlan& a, float a_impact_s, const runtime::FootPlan& b,
          float b_impact_s) {
  return near(a.offset.yaw, b.offset.yaw, kSamePlace) &&
         near(a.offset.translation, b.offset.translation) &&
         near(a.change, a_impact_s, b.change, b_impact_s) &&
         near(a.change_lift_m, b.change_lift_m, kSamePlace) &&
         near(a.home, a_impact_s, b.home, b_impact_s) &&
         near(a.home_lift_m, b.home_lift_m, kSamePlace);
}

bool near(const runtime::WeightShift& a, float a_impact_s, const runtime::WeightShift& b,
          float b_impact_s) {
  return near(a.window, a_impact_s, b.window, b_impact_s) &&
         near(a.held, a_impact_s, b.held, b_impact_s) && near(a.pelvis, b.pelvis);
}

bool is_idle(const runtime::Response& response) {
  return response.clip == response.library->library->idle;
}

}  // namespace

bool is_same_from_impact(const runtime::Response& early, float early_time_s,
                         const runtime::Response& late, float late_time_s) {
  if (is_idle(early)) return is_idle(late);
  const auto at_same_time = [&](float a_s, float b_s) {
    return near(a_s - early_time_s, b_s - late_time_s, kSameTime);
  };
  bool same =
      early.clip == late.clip && early.support == late.support &&
      at_same_time(early.start_s, late.start_s) && at_same_time(early.begin_s, late.begin_s) &&
      at_same_time(early.peak_s, late.peak_s) && at_same_time(early.end_s, late.end_s) &&
      near(early.playback_rate, late.playback_rate, kSameTime) &&
      near(early.blend_s, late.blend_s, kSameTime) &&
      near(early.return_s, late.return_s, kSameTime) && near(early.yaw, late.yaw, kSamePlace) &&
      near(early.translation, late.translation) && near(early.travel, late.travel);
  for (std::size_t i = 0; i < early.feet.size(); ++i)
    same = same && near(early.feet[i], early_time_s, late.feet[i], late_time_s);
  for (std::size_t i = 0; i < early.shifts.size(); ++i)
    same = same && near(early.shifts[i], early_time_s, late.shifts[i], late_time_s);
  return same;
}

namespace {

/// The first time from which on the clip's response is the same; negative without a response. That
/// it stays the same once it is follows from how responses are planned: every bound that more time
/// loosens stays loose.
int first_unhurried(const runtime::PreparedLibrary& library,
                    const ScenarioDistribution& distribution, int clip, int character_state) {
  const motion::Motion& idle = library.idle();
  const auto response_to = [&](int time) {
    return runtime::make_response(library,
                                  character_state_at(distribution, idle, {character_state, time}),
                                  clip, time_to_impact_s(distribution, time));
  };
  int most = time_count(distribution) - 1;
  const runtime::Response longest = response_to(most);
  if (!runtime::is_valid(longest)) return -1;
  const float longest_s = time_to_impact_s(distribution, most);
  int least = 0;
  while (least < most) {
    const int middle = (least + most) / 2;
    const bool same = is_same_from_impact(
        response_to(middle), time_to_impact_s(distribution, middle), longest, longest_s);
    (same ? most : least) = same ? middle : middle + 1;
  }
  return least;
}

}  // namespace

SharedResponses::SharedResponses(const runtime::PreparedLibrary& library,
                                 const ScenarioDistribution& distribution)
    : character_states_(distribution.character_states) {
  const auto clips = static_cast<int>(library.library->clips.size());
  for (int clip = 0; clip < clips; ++clip) {
    for (int state = 0; state < character_states_; ++state)
      unhurried_.push_back(first_unhurried(library, distribution, clip, state));
  }
}

std::size_t SharedResponses::index(int clip, int character_state) const {
  return static_cast<std::size_t>(clip * character_states_ + character_state);
}

ResponseKey SharedResponses::key_of(int clip, GridPlace place) const {
  const int unhurried = unhurried_[index(clip, place.character_state)];
  return {clip, {place.character_state, std::min(place.time, unhurried)}};
}

std::size_t SharedResponses::count() const {
  std::size_t count = 0;
  for (const int unhurried : unhurried_) count += static_cast<std::size_t>(unhurried + 1);
  return count;
}

std::size_t SharedResponses::count_at(int time) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(unhurried_, [time](int unhurried) { return unhurried >= time; }));
}

}  // namespace flinch::train
