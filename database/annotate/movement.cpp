// SPDX-License-Identifier: MIT
#include "database/annotate/movement.h"

#include <algorithm>

namespace flinch::database {
namespace {

// Between stills.
constexpr float kMinDeparture_m = 0.1F;
constexpr double kMaxPause_s = 1;     // between a movement and its return
constexpr float kMaxLeft = 0.5F;      // share of the departure that is left after a return
constexpr double kMaxReturned_s = 4;  // of a movement with its return
constexpr double kMaxUnsplit_s = 3;
constexpr float kMinStillShare = 0.1F;

// Out of a stance. "Usual" is the order statistic at 0.3: in a take with a movement every other
// second, that is still the wobble of the stance.
constexpr float kUsual = 0.3F;
constexpr float kAboveUsual = 1.6F;
constexpr float kMinPeak_m = 0.05F;
constexpr float kValley = 0.6F;  // of the lower of two peaks
constexpr float kFoot = 0.05F;   // of a peak's height above its valley: where it begins and ends
constexpr double kMaxReach_s = 1.5;

using Values = std::vector<float>;

float departure_between(const TakeSignals& signals, std::size_t from, std::size_t to) {
  return pose_distance(signals.world.joints[from], signals.world.joints[to]);
}

float largest_departure(const TakeSignals& signals, const FrameSpan& span) {
  float largest = 0;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    largest = std::max(largest, departure_between(signals, span.first, i));
  }
  return largest;
}

float lowest_between(const Values& values, std::size_t first, std::size_t last) {
  return *std::min_element(values.begin() + static_cast<std::ptrdiff_t>(first),
                           values.begin() + static_cast<std::ptrdiff_t>(last) + 1);
}

// Peaks of the departure within a span; those that a valley does not separate count once, the
// highest.
std::vector<std::size_t> separate_peaks(const Values& departure, const FrameSpan& span) {
  const Values own(departure.begin() + static_cast<std::ptrdiff_t>(span.first),
                   departure.begin() + static_cast<std::ptrdiff_t>(span.last) + 1);
  const float limit = std::max(kAboveUsual * order_statistic(own, kUsual), kMinPeak_m);
  std::vector<std::size_t> peaks;
  for (std::size_t i = span.first + 1; i < span.last; ++i) {
    const bool is_peak = departure[i] >= departure[i - 1] && departure[i] > departure[i + 1];
    if (!is_peak || departure[i] <= limit) continue;
    if (peaks.empty() || lowest_between(departure, peaks.back(), i) <=
                             kValley * std::min(departure[peaks.back()], departure[i])) {
      peaks.push_back(i);
    } else if (departure[i] > departure[peaks.back()]) {
      peaks.back() = i;
    }
  }
  return peaks;
}

// Walks from a peak towards `limit`, which lies before or after it, to the foot: where the
// departure has come down to the valley on this side, but for a twentieth.
std::size_t foot_of(const Values& departure, std::size_t peak, std::size_t limit) {
  const auto [first, last] = std::minmax(peak, limit);
  const float valley = lowest_between(departure, first, last);
  const float low = valley + kFoot * (departure[peak] - valley);
  std::size_t foot = peak;
  while (foot != limit && departure[foot] > low) foot += limit > peak ? 1 : std::size_t(-1);
  return foot;
}

void add_excursions(const TakeSignals& signals, const FrameSpan& span,
                    std::vector<Movement>& movements) {
  const std::vector<std::size_t> peaks = separate_peaks(signals.departure_m, span);
  const std::size_t reach = frames_in(kMaxReach_s, signals.world.rate_hz);
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const std::size_t before = k > 0 ? peaks[k - 1] : span.first;
    const std::size_t after = k + 1 < peaks.size() ? peaks[k + 1] : span.last;
    const std::size_t earliest = std::max(before, peaks[k] - std::min(reach, peaks[k]));
    const std::size_t latest = std::min(after, peaks[k] + reach);
    movements.push_back({{foot_of(signals.departure_m, peaks[k], earliest),
                          foot_of(signals.departure_m, peaks[k], latest)},
                         true});
  }
}

std::vector<FrameSpan> moving_spans(const TakeSignals& signals) {
  std::vector<bool> moves(signals.world.count(), true);
  for (const FrameSpan& span : signals.still) {
    for (std::size_t i = span.first; i <= span.last; ++i) moves[i] = false;
  }
  return spans_of(moves);
}

bool is_return(const TakeSignals& signals, const FrameSpan& out, const FrameSpan& next) {
  const float rate = signals.world.rate_hz;
  if (next.first - out.last >= frames_in(kMaxPause_s, rate)) return false;
  if (next.last - out.first >= frames_in(kMaxReturned_s, rate)) return false;
  return departure_between(signals, out.first, next.last) <
         kMaxLeft * departure_between(signals, out.first, out.last);
}

std::vector<Movement> joined_with_returns(const TakeSignals& signals,
                                          const std::vector<Movement>& movements) {
  std::vector<Movement> joined;
  for (std::size_t i = 0; i < movements.size(); ++i) {
    joined.push_back(movements[i]);
    if (i + 1 == movements.size()) break;
    const Movement& next = movements[i + 1];
    if (movements[i].from_moving_stance || next.from_moving_stance) continue;
    if (!is_return(signals, movements[i].span, next.span)) continue;
    joined.back().span.last = next.span.last;
    ++i;
  }
  return joined;
}

// The moving stance of the whole take, but for the stills at its ends.
FrameSpan between_ends(const TakeSignals& signals) {
  FrameSpan span{0, signals.world.count() - 1};
  if (signals.still.empty()) return span;
  if (signals.still.front().first == 0) span.first = signals.still.front().last;
  if (signals.still.back().last == span.last) span.last = signals.still.back().first;
  return span;
}

bool is_restless(const TakeSignals& signals) {
  std::size_t still = 0;
  for (const FrameSpan& span : signals.still) still += span.count();
  const std::size_t count = signals.world.count();
  return count > frames_in(kMaxUnsplit_s, signals.world.rate_hz) &&
         static_cast<float>(still) < kMinStillShare * static_cast<float>(count);
}

}  // namespace

TakeSignals signals_of(const motion::Figure& figure, const motion::Motion& motion) {
  TakeSignals signals;
  signals.world = trajectory_of(figure, motion);
  signals.relative = relative_to_stance(signals.world);
  signals.speed_mps = body_speed(signals.world);
  signals.departure_m = departure_from_stance(signals.relative, motion.rate_hz);
  signals.still_limit_mps = still_limit(signals.speed_mps);
  signals.still = still_spans(signals.speed_mps, signals.still_limit_mps, motion.rate_hz);
  return signals;
}

std::vector<Movement> find_movements(const TakeSignals& signals) {
  std::vector<Movement> movements;
  if (is_restless(signals)) {
    add_excursions(signals, between_ends(signals), movements);
  } else {
    for (const FrameSpan& span : moving_spans(signals)) {
      if (span.count() > frames_in(kMaxUnsplit_s, signals.world.rate_hz)) {
        add_excursions(signals, span, movements);
      } else if (largest_departure(signals, span) > kMinDeparture_m) {
        movements.push_back({span, false});
      }
    }
    movements = joined_with_returns(signals, movements);
  }
  std::erase_if(movements, [&](const Movement& movement) {
    return is_t_pose(signals.world.joints[movement.span.first]) ||
           is_t_pose(signals.world.joints[movement.span.last]);
  });
  return movements;
}

}  // namespace flinch::database
