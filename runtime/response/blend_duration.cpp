// SPDX-License-Identifier: MIT
#include "runtime/response/blend_duration.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "motion/rotation.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::Role;

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

}  // namespace

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

}  // namespace flinch::runtime
