// SPDX-License-Identifier: MIT
#include "database/annotate/rest.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace flinch::database {
namespace {

using motion::Role;

constexpr double kMinStill_s = 0.2;
constexpr double kMinIdle_s = 0.5;
constexpr float kMaxIdleSpeed_mps = 0.6F;

std::string idle_reason(const char* what, float speed_mps) {
  char text[96];
  std::snprintf(text, sizeof text, "%s, at %.2f m/s", what, static_cast<double>(speed_mps));
  return text;
}

float mean_in(const std::vector<float>& values, const FrameSpan& span) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(span.first);
  return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(span.count()), 0.0F) /
         static_cast<float>(span.count());
}

bool touches_t_pose(const Trajectory& trajectory, const FrameSpan& span) {
  return is_t_pose(trajectory.joints[span.first]) || is_t_pose(trajectory.joints[span.last]);
}

std::optional<FrameSpan> longest_rest(const Trajectory& trajectory,
                                      const std::vector<FrameSpan>& still) {
  std::optional<FrameSpan> longest;
  for (const FrameSpan& span : still) {
    if (span.count() < frames_in(kMinIdle_s, trajectory.rate_hz)) continue;
    if (touches_t_pose(trajectory, span)) continue;
    if (!longest || span.count() > longest->count()) longest = span;
  }
  return longest;
}

std::optional<FrameSpan> quietest_moment(const Trajectory& trajectory,
                                         const std::vector<float>& speed,
                                         const std::vector<float>& departure) {
  const float usual = order_statistic(departure, 0.5F);
  const std::size_t count = frames_in(kMinStill_s, trajectory.rate_hz);
  std::optional<FrameSpan> quietest;
  for (std::size_t first = 0; first + count <= speed.size(); ++first) {
    const FrameSpan span{first, first + count - 1};
    if (touches_t_pose(trajectory, span) || mean_in(departure, span) > usual) continue;
    if (!quietest || mean_in(speed, span) < mean_in(speed, *quietest)) quietest = span;
  }
  return quietest;
}

}  // namespace

float confidence_above(float value, float limit) {
  const float ratio = std::max(value, 0.0F) / limit;
  return ratio * ratio / (1 + ratio * ratio);
}

float still_limit(const std::vector<float>& speed) {
  return std::clamp(0.3F * order_statistic(speed, 0.9F), 0.05F, 0.3F);
}

std::vector<FrameSpan> still_spans(const std::vector<float>& speed, float limit_mps,
                                   float rate_hz) {
  std::vector<bool> is_slow;
  for (float value : moving_mean(speed, frames_in(0.05, rate_hz))) {
    is_slow.push_back(value < limit_mps);
  }
  std::vector<FrameSpan> spans = spans_of(is_slow);
  std::erase_if(
      spans, [&](const FrameSpan& span) { return span.count() < frames_in(kMinStill_s, rate_hz); });
  return spans;
}

std::optional<Guess<FrameSpan>> find_idle(const Trajectory& trajectory,
                                          const std::vector<float>& speed,
                                          const std::vector<float>& departure,
                                          const std::vector<FrameSpan>& still) {
  const std::optional<FrameSpan> rest = longest_rest(trajectory, still);
  const std::optional<FrameSpan> idle = rest ? rest : quietest_moment(trajectory, speed, departure);
  if (!idle) return std::nullopt;
  const float speed_mps = mean_in(speed, *idle);
  if (speed_mps > kMaxIdleSpeed_mps) return std::nullopt;
  return Guess<FrameSpan>{
      *idle, 1 - confidence_above(speed_mps, 0.3F),
      idle_reason(rest ? "the longest rest" : "never still: the calmest moment", speed_mps)};
}

}  // namespace flinch::database
