// SPDX-License-Identifier: MIT
#include "database/annotate/protection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::Degree;
using motion::Role;
using motion::Target;

constexpr float kEighth = std::numbers::pi_v<float> / 4;
constexpr double kFacingReach_s = 0.1;
constexpr float kAside_m = 0.19F;
constexpr float kLongStep_m = 0.57F;
constexpr float kForwardJump_m = 0.5F;
// One of these shows a block's side: a hand higher than the other, the head moved, the face turned.
constexpr float kHandsApart_m = 0.15F;
constexpr float kHeadAside_m = 0.1F;
constexpr float kFaceTurned = kEighth;

// What moved from the onset to the peak, in the actor's axes: X forward, Y left.
struct Displacement {
  Eigen::Vector3f head;
  Eigen::Vector3f pelvis;
  float face_turn = 0;    // radians counter-clockwise
  float hands_apart = 0;  // left wrist over the right one at the peak
};

Displacement displacement_of(const TakeSignals& signals, const MovementTimes& times, float facing) {
  const Trajectory& world = signals.world;
  const Eigen::AngleAxisf turn(-facing, Eigen::Vector3f::UnitZ());
  const JointPositions& from = world.joints[times.onset];
  const JointPositions& to = world.joints[times.peak];
  Displacement moved;
  moved.head = turn * Eigen::Vector3f(to[Role::head] - from[Role::head]);
  moved.pelvis = turn * Eigen::Vector3f(to[Role::pelvis] - from[Role::pelvis]);
  moved.face_turn = world.head_yaw[times.peak] - world.head_yaw[times.onset];
  moved.hands_apart = to[Role::left_hand].z() - to[Role::right_hand].z();
  return moved;
}

std::string written(const char* format, float value) {
  char text[96];
  std::snprintf(text, sizeof text, format, static_cast<double>(value));
  return text;
}

float nearest_eighth(float angle) {
  const float rounded = kEighth * std::round(motion::wrapped_to_pi(angle) / kEighth);
  return rounded <= -std::numbers::pi_v<float> + 0.1F ? std::numbers::pi_v<float> : rounded;
}

// The threat comes from where the body does not go.
Guess<float> against(const Eigen::Vector3f& displacement, const char* what) {
  const float distance = displacement.head<2>().norm();
  return {nearest_eighth(motion::yaw_of(Eigen::Vector3f(-displacement))),
          confidence_above(distance, kHeadAside_m),
          written((std::string(what) + " goes %.2f m the other way").c_str(), distance)};
}

Guess<float> from_side(float leftness, std::string reason) {
  const float confidence = confidence_above(std::abs(leftness), 1);
  if (std::abs(leftness) < 1) return {0, 1 - confidence, "neither side is favoured"};
  return {leftness > 0 ? kEighth : -kEighth, confidence, std::move(reason)};
}

Guess<float> direction_of(const Displacement& moved, const MovementMeasures& measures,
                          MovementKind kind) {
  switch (kind) {
    case MovementKind::duck:
      return from_side(-moved.head.y() / kAside_m, "the head sinks to the other side");
    case MovementKind::dodge:
      return against(moved.head, "the head");
    case MovementKind::step:
    case MovementKind::push:
      return against(moved.pelvis, "the pelvis");
    case MovementKind::lift:
      if (moved.pelvis.x() >= kForwardJump_m && measures.both_feet_rise_m >= kJumpRise_m) {
        return {std::numbers::pi_v<float>, 0.5F, "the body jumps forward"};
      }
      return {0, 0.5F, "a foot is lifted out of the way: assumed"};
    case MovementKind::block:
      if (measures.hand_speed_mps >= kThrownHand_mps && measures.hand_over_head_m < 0) {
        return {0, confidence_above(measures.hand_speed_mps, kThrownHand_mps),
                "the hands are thrown"};
      }
      return from_side(moved.hands_apart / kHandsApart_m - moved.head.y() / kHeadAside_m -
                           moved.face_turn / kFaceTurned,
                       "by the higher hand, head and face");
    case MovementKind::flinch:
      break;
  }
  if (moved.head.x() > std::abs(moved.head.y())) {
    return {0, confidence_above(moved.head.x(), kHeadAside_m), "the body folds forward"};
  }
  return against(moved.head, "the head");
}

Guess<Target> target_of_block(const JointPositions& peak) {
  const float wrist = std::max(peak[Role::left_hand].z(), peak[Role::right_hand].z());
  const float head = peak[Role::head].z() - 0.1F;
  const float navel = peak[Role::abdomen].z();
  const float trunk_half = (head - navel) / 2;
  // As certain as the wrist is far from the nearest border, in halves of the trunk.
  const float clearance = std::min(std::abs(wrist - head), std::abs(wrist - navel)) / trunk_half;
  const float confidence = 0.5F + 0.5F * std::min(clearance, 1.0F);
  if (wrist >= head) return {Target::head, confidence, "a wrist is at the head"};
  if (wrist >= navel) return {Target::trunk, confidence, "the higher wrist is before the trunk"};
  return {Target::pelvis, confidence, "both wrists are below the navel"};
}

Guess<Target> target_of(const Displacement& moved, const MovementMeasures& measures,
                        MovementKind kind, const JointPositions& peak) {
  switch (kind) {
    case MovementKind::duck:
    case MovementKind::dodge:
      return {Target::head, 0.9F, "the head moves most"};
    case MovementKind::lift:
      return {Target::legs, 0.9F, "the feet leave the ground"};
    case MovementKind::push:
      return {Target::trunk, 0.5F, "pushes are felt at the trunk: assumed"};
    case MovementKind::step: {
      const float longer = confidence_above(measures.travel_m, kLongStep_m);
      if (longer >= 0.5F) return {Target::trunk, longer, "the step is long"};
      return {Target::pelvis, 1 - longer, "the step is short"};
    }
    case MovementKind::block:
      return target_of_block(peak);
    case MovementKind::flinch:
      break;
  }
  const float forward = confidence_above(moved.head.x(), std::abs(moved.head.y()) + 0.01F);
  if (forward >= 0.5F) return {Target::trunk, forward, "the body folds forward"};
  return {Target::head, 1 - forward, "the head gives way"};
}

bool is_large(const Displacement& moved, const MovementMeasures& m, MovementKind kind) {
  const float turn = std::abs(motion::degrees(moved.face_turn));
  switch (kind) {
    case MovementKind::duck:
      return m.head_drop_m >= 0.4F;
    case MovementKind::dodge:
      return true;
    case MovementKind::step:
      return m.travel_m >= kLongStep_m;
    case MovementKind::lift:
      return m.foot_rise_m >= 0.97F || m.both_feet_rise_m >= 0.49F;
    case MovementKind::push:
      return m.centre_speed_mps >= 0.85F;
    case MovementKind::block:
      if (m.hand_over_head_m < 0) return m.travel_m >= 1.05F;
      return moved.head.norm() >= kAside_m || m.hand_over_head_m >= 0.16F || turn >= 80;
    case MovementKind::flinch:
      break;
  }
  return m.head_shift_m >= 0.29F || m.head_drop_m >= 0.21F || turn >= 90;
}

}  // namespace

int whole_degrees(float angle_rad) {
  return static_cast<int>(std::lround(motion::degrees(angle_rad)));
}

float facing_at(const Trajectory& world, std::size_t frame) {
  const std::size_t reach = frames_in(kFacingReach_s, world.rate_hz);
  const std::size_t first = frame - std::min(frame, reach);
  const std::size_t last = std::min(frame + reach, world.count() - 1);
  float sum = 0;
  for (std::size_t i = first; i <= last; ++i) sum += world.head_yaw[i];
  return sum / static_cast<float>(last - first + 1);
}

Protection protection_of(const TakeSignals& signals, const MovementTimes& times,
                         const MovementMeasures& measures, MovementKind kind, float facing) {
  const Displacement moved = displacement_of(signals, times, facing);
  return {target_of(moved, measures, kind, signals.world.joints[times.peak]),
          direction_of(moved, measures, kind),
          is_large(moved, measures, kind) ? Degree::exaggerated : Degree::mild};
}

}  // namespace flinch::database
