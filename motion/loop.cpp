// SPDX-License-Identifier: MIT
#include "motion/loop.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::motion {
namespace {

constexpr float kLeastTravel_m = 0.02F;
constexpr float kLeastTurn = radians(2);

/// From the first pose of a motion to its last.
PlanarMove travel_of(const Motion& motion) {
  const Pose& first = motion.poses.front();
  const Pose& last = motion.poses.back();
  PlanarMove move;
  move.yaw = wrapped_to_pi(facing(last) - facing(first));
  move.translation =
      last.root_position - rotation_about(Eigen::Vector3f::UnitZ(), move.yaw) * first.root_position;
  move.translation.z() = 0;
  return move;
}

/// A time in the motion of a loop.
float time_in_motion(const Loop& loop, float time_s, int cycles) {
  const float duration_s = loop.motion().duration_s();
  return std::clamp(time_s - static_cast<float>(cycles) * duration_s, 0.0F, duration_s);
}

}  // namespace

// A turn by a and a shift t, n times, is a turn by n a and the shift
//
//   (1 + R + ... + R^(n-1)) t = sin(n a / 2) / sin(a / 2) R^((n-1)/2) t.
PlanarMove repeated(const PlanarMove& move, int times) {
  constexpr float kStraight = 1e-5F;  // radians
  const auto n = static_cast<float>(times);
  const float half = 0.5F * move.yaw;
  const float sum = std::abs(half) < kStraight ? n : std::sin(n * half) / std::sin(half);
  const Eigen::Quaternionf turn = rotation_about(Eigen::Vector3f::UnitZ(), (n - 1) * half);
  return {n * move.yaw, sum * (turn * move.translation)};
}

Loop Loop::in_cycles(const Motion& motion) {
  Loop loop(motion);
  loop.has_cycles_ = true;
  loop.travel_ = travel_of(motion);
  return loop;
}

float Loop::period_s() const {
  return has_cycles_ ? motion_->duration_s() : 2 * motion_->duration_s();
}

bool Loop::travels() const {
  return travel_.translation.norm() > kLeastTravel_m || std::abs(travel_.yaw) > kLeastTurn;
}

int Loop::cycles_before(float time_s) const {
  constexpr float kMostCycles = 1e6F;
  const float duration_s = motion_->duration_s();
  if (!has_cycles_ || !(duration_s > 0)) return 0;
  return static_cast<int>(std::clamp(std::floor(time_s / duration_s), -kMostCycles, kMostCycles));
}

Pose sample(const Loop& loop, float time_s, std::span<const Role> roles) {
  if (!loop.has_cycles()) return sample_ping_pong(loop.motion(), time_s, roles);
  const int cycles = loop.cycles_before(time_s);
  Pose pose = sample(loop.motion(), time_in_motion(loop, time_s, cycles), roles);
  if (cycles == 0) return pose;
  const PlanarMove move = repeated(loop.travel(), cycles);
  place(move.yaw, move.translation, pose);
  return pose;
}

const Pose& pose_before(const Loop& loop, float time_s) {
  if (!loop.has_cycles()) return pose_before_ping_pong(loop.motion(), time_s);
  return pose_before(loop.motion(), time_in_motion(loop, time_s, loop.cycles_before(time_s)));
}

LoopGap loop_gap(const Motion& motion) {
  const Pose& first = motion.poses.front();
  const PlanarMove travel = travel_of(motion);
  const Pose again = placed(first, travel.yaw, travel.translation);
  const Pose& last = motion.poses.back();
  LoopGap gap;
  gap.height_m = std::abs(last.root_position.z() - again.root_position.z());
  for (Role role : kRoles) {
    const float angle = last.rotation[role].angularDistance(again.rotation[role]);
    if (angle > gap.angle) {
      gap.angle = angle;
      gap.joint = role;
    }
  }
  return gap;
}

}  // namespace flinch::motion
