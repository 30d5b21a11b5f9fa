// SPDX-License-Identifier: MIT
#include "motion/clip.h"

#include <algorithm>
#include <cmath>

#include "motion/enum_names.h"
#include "motion/interpolation.h"

namespace flinch::motion {
namespace {

constexpr PerTarget<std::string_view> kTargetNames{"head", "trunk", "pelvis", "legs"};
constexpr EnumArray<Degree, std::string_view, 2> kDegreeNames{"mild", "exaggerated"};
constexpr EnumArray<Purpose, std::string_view, 4> kPurposeNames{"anticipation", "idle", "push",
                                                                "stance"};

/// A time in a motion: the index of a pose, and the fraction of the interval to the next pose.
struct Place {
  std::size_t index;
  float weight;
};

Place place_at(const Motion& motion, float time_s) {
  const float last = static_cast<float>(motion.poses.size() - 1);
  const float position = std::clamp(time_s * motion.rate_hz, 0.0F, last);
  const auto index = static_cast<std::size_t>(position);
  return {index, position - static_cast<float>(index)};
}

float ping_pong_time(const Motion& motion, float time_s) {
  const float duration = motion.duration_s();
  if (duration <= 0) return 0;
  const float phase = std::fmod(std::abs(time_s), 2 * duration);
  return phase <= duration ? phase : 2 * duration - phase;
}

}  // namespace

std::string_view name_of(Target target) {
  return kTargetNames[target];
}
std::optional<Target> target_named(std::string_view name) {
  return enum_named(kTargetNames, name);
}

std::string_view name_of(Degree degree) {
  return kDegreeNames[degree];
}
std::optional<Degree> degree_named(std::string_view name) {
  return enum_named(kDegreeNames, name);
}

bool is_push_place(Role role) {
  return std::ranges::find(kPushPlaces, role) != kPushPlaces.end();
}

std::string_view push_place_name(Role place) {
  if (place == Role::left_upper_arm) return "left_shoulder";
  if (place == Role::right_upper_arm) return "right_shoulder";
  return is_push_place(place) ? name_of(place) : "";
}

std::optional<Role> push_place_named(std::string_view name) {
  for (const Role place : kPushPlaces) {
    if (push_place_name(place) == name) return place;
  }
  return std::nullopt;
}

std::string_view name_of(Purpose purpose) {
  return kPurposeNames[purpose];
}

Pose sample(const Motion& motion, float time_s, std::span<const Role> roles) {
  const Place place = place_at(motion, time_s);
  if (place.weight == 0) return motion.poses[place.index];
  return blend(motion.poses[place.index], motion.poses[place.index + 1], place.weight, roles);
}

Pose sample_ping_pong(const Motion& motion, float time_s, std::span<const Role> roles) {
  return sample(motion, ping_pong_time(motion, time_s), roles);
}

const Pose& pose_before(const Motion& motion, float time_s) {
  return motion.poses[place_at(motion, time_s).index];
}

const Pose& pose_before_ping_pong(const Motion& motion, float time_s) {
  return pose_before(motion, ping_pong_time(motion, time_s));
}

}  // namespace flinch::motion
