// SPDX-License-Identifier: MIT
#include "database/annotate/timing.h"

#include <algorithm>
#include <functional>

namespace flinch::database {
namespace {

using motion::Role;

constexpr float kAhead = 0.95F;
constexpr float kBehind = 0.15F;
constexpr double kMaxEarlier_s = 0.15;
constexpr float kTurnedBack = 0.9F;
constexpr float kHeadUnderway = 0.2F;
constexpr double kMaxLead_s = 0.3;
constexpr float kHandsHeld = 0.25F;
constexpr float kContactShare = 0.1F;

using Poses = std::vector<JointPositions>;
using FrameValue = std::function<float(std::size_t)>;

// Returns the first frame of a span at which a value is largest.
std::size_t frame_of_largest(const FrameSpan& span, const FrameValue& value) {
  std::size_t best = span.first;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    if (value(i) > value(best)) best = i;
  }
  return best;
}

std::size_t first_hold_of_hands(const TakeSignals& signals, const FrameSpan& span) {
  const std::vector<float> speed = speed_of_hands(signals);
  std::size_t frame = frame_of_largest(span, [&](std::size_t i) { return speed[i]; });
  const float held = kHandsHeld * speed[frame];
  while (frame < span.last && speed[frame] > held) ++frame;
  return frame;
}

std::size_t peak_of(const TakeSignals& signals, const FrameSpan& span,
                    const MovementMeasures& measures, MovementKind kind) {
  const Poses& joints = signals.world.joints;
  const JointPositions& first = joints[span.first];
  const auto rise = [&](std::size_t i, Role role) { return joints[i][role].z() - first[role].z(); };
  switch (kind) {
    case MovementKind::duck:
    case MovementKind::dodge:
      return frame_of_largest(span, [&](std::size_t i) { return -rise(i, Role::head); });
    case MovementKind::step:
    case MovementKind::push:
      return frame_of_largest(span, [&](std::size_t i) {
        return (joints[i][Role::pelvis] - first[Role::pelvis]).head<2>().norm();
      });
    case MovementKind::lift: {
      const bool jumps = measures.both_feet_rise_m >= kJumpRise_m;
      return frame_of_largest(span, [&](std::size_t i) {
        const float left = rise(i, Role::left_foot);
        const float right = rise(i, Role::right_foot);
        return jumps ? std::min(left, right) : std::max(left, right);
      });
    }
    case MovementKind::block:
      if (measures.hand_speed_mps >= kThrownHand_mps) return first_hold_of_hands(signals, span);
      break;
    case MovementKind::flinch:
      break;
  }
  return frame_of_largest(span, [&](std::size_t i) {
    return pose_distance(signals.relative[i], signals.relative[span.first]);
  });
}

// How far the head has gone from where it rests before the movement.
FrameValue head_displacement(const TakeSignals& signals, const FrameSpan& before_peak,
                             MovementKind kind) {
  const Poses& joints = signals.world.joints;
  if (kind == MovementKind::duck) {
    const std::size_t earlier = frames_in(0.25, signals.world.rate_hz);
    std::vector<float> heights;
    for (std::size_t i = before_peak.first - std::min(earlier, before_peak.first);
         i <= before_peak.last; ++i) {
      heights.push_back(joints[i][Role::head].z());
    }
    const float standing = order_statistic(heights, 0.75F);
    return [&joints, standing](std::size_t i) { return standing - joints[i][Role::head].z(); };
  }
  const Eigen::Vector3f first = signals.relative[before_peak.first][Role::head];
  return [&signals, first](std::size_t i) {
    return (signals.relative[i][Role::head] - first).head<2>().norm();
  };
}

// Returns the frame that distances to the first pose are measured from.
std::size_t start_of(const TakeSignals& signals, const Movement& movement, std::size_t peak,
                     MovementKind kind) {
  const float rate = signals.world.rate_hz;
  std::size_t start = movement.span.first;
  if (kind == MovementKind::duck || kind == MovementKind::dodge || kind == MovementKind::flinch) {
    const FrameValue gone = head_displacement(signals, {start, peak}, kind);
    const float underway = kHeadUnderway * gone(peak);
    std::size_t frame = peak;
    while (frame > start && gone(frame) > underway) --frame;
    start = std::max(start, frame - std::min(frame, frames_in(kMaxLead_s, rate)));
  }
  if (!movement.from_moving_stance || start > movement.span.first) return start;
  const auto ahead = [&](std::size_t i) {
    return pose_distance(signals.relative[i], signals.relative[peak]);
  };
  const std::size_t earliest = start - std::min(start, frames_in(kMaxEarlier_s, rate));
  for (std::size_t i = start; i-- > earliest;) {
    if (ahead(i) > ahead(start)) {
      start = i;
    } else if (ahead(i) < kTurnedBack * ahead(start)) {
      break;
    }
  }
  return start;
}

std::size_t onset_of(const Poses& poses, std::size_t start, std::size_t peak) {
  std::vector<float> ahead, behind;  // distance to the peak's pose, and from the start's
  for (std::size_t i = start; i <= peak; ++i) {
    ahead.push_back(pose_distance(poses[i], poses[peak]));
    behind.push_back(pose_distance(poses[i], poses[start]));
  }
  const float far_ahead = kAhead * *std::max_element(ahead.begin(), ahead.end());
  const float near_start = kBehind * *std::max_element(behind.begin(), behind.end());
  std::size_t straight = peak - start;
  while (straight > 0 && ahead[straight] < far_ahead) --straight;
  std::size_t wound_up = 0;
  while (wound_up < peak - start && behind[wound_up + 1] <= near_start) ++wound_up;
  return start + std::min(straight, wound_up);
}

}  // namespace

MovementTimes times_of(const TakeSignals& signals, const Movement& movement,
                       const MovementMeasures& measures, MovementKind kind) {
  const FrameSpan& span = movement.span;
  MovementTimes times;
  times.peak = std::max(peak_of(signals, span, measures, kind), span.first + 1);
  const std::size_t start = start_of(signals, movement, times.peak, kind);
  const Poses& poses = movement.from_moving_stance ? signals.relative : signals.world.joints;
  times.onset = std::min(onset_of(poses, start, times.peak), times.peak - 1);
  return times;
}

std::size_t contact_of(const TakeSignals& signals, const Movement& movement) {
  const Poses& joints = signals.world.joints;
  const FrameSpan& span = movement.span;
  const auto velocity = [&](std::size_t i) -> Eigen::Vector2f {
    if (i == 0) return Eigen::Vector2f::Zero();
    return (joints[i][Role::chest] - joints[i - 1][Role::chest]).head<2>() * signals.world.rate_hz;
  };
  std::size_t frame = frame_of_largest(span, [&](std::size_t i) { return velocity(i).norm(); });
  const Eigen::Vector2f fastest = velocity(frame);
  while (frame > span.first &&
         velocity(frame).dot(fastest) > kContactShare * fastest.squaredNorm()) {
    --frame;
  }
  return frame;
}

}  // namespace flinch::database
