// SPDX-License-Identifier: MIT
#include "database/annotate/draft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

constexpr motion::PerTarget<std::string_view> kHeights{"high", "body", "hip", "legs"};
// By eighths of a turn, counter-clockwise from the front.
constexpr std::array<std::string_view, 8> kSides{"front", "front_left", "left",  "back_left",
                                                 "back",  "back_right", "right", "front_right"};

double seconds_at(const Take& take, std::size_t frame) {
  return take.start_s + static_cast<double>(frame) / static_cast<double>(take.motion.rate_hz);
}

std::string name_stem(const DraftClip& clip) {
  const auto eighth =
      static_cast<std::size_t>((whole_degrees(clip.protection.direction.value) / 45 + 8) % 8);
  return std::string(name_of(clip.kind.value)) + "_" +
         std::string(kHeights[clip.protection.target.value]) + "_" + std::string(kSides[eighth]);
}

void number(std::vector<DraftClip>& clips) {
  std::map<std::string, int> count;
  for (DraftClip& clip : clips) {
    const std::string stem = name_stem(clip);
    clip.name = stem + "_" + std::to_string(++count[stem]);
  }
}

// The angle from where the pelvis faces to where the actor does.
float heading_at(const TakeSignals& signals, std::size_t frame) {
  return motion::wrapped_to_pi(facing_at(signals.world, frame) - signals.world.pelvis_yaw[frame]);
}

DraftClip clip_of(const Take& take, const TakeSignals& signals, const Movement& movement) {
  const MovementMeasures measures = measures_of(signals, movement);
  DraftClip clip;
  clip.kind = kind_of(measures);
  const MovementTimes times = times_of(signals, movement, measures, clip.kind.value);
  const std::size_t start = std::min(movement.span.first, times.onset);
  clip.protection =
      protection_of(signals, times, measures, clip.kind.value, facing_at(signals.world, start));
  clip.start_s = seconds_at(take, start);
  clip.onset_s = seconds_at(
      take, clip.kind.value == MovementKind::push ? contact_of(signals, movement) : times.onset);
  clip.peak_s = seconds_at(take, times.peak);
  clip.end_s = seconds_at(take, std::max(movement.span.last, times.peak));
  clip.heading = heading_at(signals, start);
  return clip;
}

}  // namespace

Draft draft_of(const Take& take) {
  const TakeSignals signals = signals_of(take.figure, take.motion);
  const auto idle = find_idle(signals.world, signals.speed_mps, signals.departure_m, signals.still);
  if (!idle) {
    throw Error(
        take.source.path,
        "is never still: the joints always move at more than 0.6 m/s, so there is no idle clip "
        "to start from; give a take in which the actor also stands");
  }
  Draft draft;
  draft.still_limit_mps = signals.still_limit_mps;
  draft.idle = {seconds_at(take, idle->value.first), seconds_at(take, idle->value.last),
                idle->confidence, idle->reason, heading_at(signals, idle->value.first)};
  for (const FrameSpan& span : signals.still) {
    draft.still.push_back({seconds_at(take, span.first), seconds_at(take, span.last)});
  }
  for (const Movement& movement : find_movements(signals)) {
    draft.clips.push_back(clip_of(take, signals, movement));
  }
  number(draft.clips);
  return draft;
}

}  // namespace flinch::database
