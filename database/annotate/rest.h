// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/annotate/signals.h"
#include "database/annotate/trajectory.h"

namespace flinch::database {

/// A value that was guessed from the motion.
template <class Value>
struct Guess {
  Value value{};
  float confidence = 0;  ///< 0 to 1; 0.5 where the motion is exactly at the limit of a rule
  std::string reason;    ///< what the motion shows, in a few words
};

/// Confidence of a rule "value >= limit" for values from 0 on: r^2 / (1 + r^2) with r = value /
/// limit. 0.5 at the limit, 0.8 at twice the limit, 0.2 at half of it; the confidence of the
/// opposite rule is what remains to 1.
float confidence_above(float value, float limit);

/// Returns the body speed below which a take counts as still, m/s: 0.3 of what it exceeds for a
/// tenth of its time, within 0.05 and 0.3. The pulse of a movement rises through 0.3 of its height
/// in its first tenth of a second. Quiet standing is slower than 0.05; a walk, at 1 and more, does
/// not come down to 0.3.
float still_limit(const std::vector<float>& speed);

/// Returns the spans in which the body stays below the limit for at least 0.2 s.
std::vector<FrameSpan> still_spans(const std::vector<float>& speed, float limit_mps, float rate_hz);

/// Returns the span to take for the idle clip: the longest still span of at least 0.5 s that is no
/// T-pose; else the fifth of a second with the lowest mean speed, if that is at most 0.6 m/s, as in
/// a boxer's guard. There, only spans that are no farther from the stance than half of the take
/// count, since a block may be held more calmly than the guard. Nothing where the body is never so
/// slow.
std::optional<Guess<FrameSpan>> find_idle(const Trajectory& trajectory,
                                          const std::vector<float>& speed,
                                          const std::vector<float>& departure,
                                          const std::vector<FrameSpan>& still);

}  // namespace flinch::database
