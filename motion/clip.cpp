// SPDX-License-Identifier: MIT
#include "motion/clip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/enum_names.h"
#include "motion/interpolation.h"

namespace flinch::motion {
namespace {

constexpr std::array<std::string_view, kTargetCount> kTargetNames{"head", "trunk", "pelvis",
                                                                  "legs"};
constexpr std::array<std::string_view, 2> kDegreeNames{"mild", "exaggerated"};
constexpr std::array<std::string_view, 3> kPurposeNames{"anticipation", "idle", "push"};

}  // namespace

std::string_view name_of(Target target) {
  return kTargetNames[static_cast<std::size_t>(target)];
}
std::optional<Target> target_named(std::string_view name) {
  return enum_named<Target>(kTargetNames, name);
}

std::string_view name_of(Degree degree) {
  return kDegreeNames[static_cast<std::size_t>(degree)];
}
std::optional<Degree> degree_named(std::string_view name) {
  return enum_named<Degree>(kDegreeNames, name);
}

std::string_view name_of(Purpose purpose) {
  return kPurposeNames[static_cast<std::size_t>(purpose)];
}

Pose sample(const Motion& motion, float time_s, std::span<const Role> roles) {
  const float last = static_cast<float>(motion.poses.size() - 1);
  const float position = std::clamp(time_s * motion.rate_hz, 0.0F, last);
  const float floor = std::floor(position);
  const auto index = static_cast<std::size_t>(floor);
  const float weight = position - floor;
  if (weight == 0) return motion.poses[index];
  return blend(motion.poses[index], motion.poses[index + 1], weight, roles);
}

Pose sample_ping_pong(const Motion& motion, float time_s, std::span<const Role> roles) {
  const float duration = motion.duration_s();
  if (duration <= 0) return motion.poses.front();
  const float phase = std::fmod(std::abs(time_s), 2 * duration);
  return sample(motion, phase <= duration ? phase : 2 * duration - phase, roles);
}

}  // namespace flinch::motion
