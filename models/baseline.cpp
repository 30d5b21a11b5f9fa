// SPDX-License-Identifier: MIT
#include "models/baseline.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "motion/rotation.h"

namespace flinch::models {

int nearest_annotation(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       float azimuth) {
  const ClipMask allowed = allowed_clips(clips, idle, threatened);
  int best = idle;
  std::pair<bool, double> best_rank{true, 2 * std::numbers::pi};  // other target, angle
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!allowed[i] || static_cast<int>(i) == idle || !clips[i].annotation) {
      continue;
    }
    const motion::Annotation& annotation = *clips[i].annotation;
    const double angle = std::abs(motion::wrapped_to_pi(static_cast<double>(annotation.direction) -
                                                        static_cast<double>(azimuth)));
    const std::pair rank{annotation.target != threatened, angle};
    if (rank < best_rank) {
      best_rank = rank;
      best = static_cast<int>(i);
    }
  }
  return best;
}

// Reducing 64 bits to the few clips of a library favours none of them by more than 2^-50.
int random_allowed(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                   std::uint64_t draw) {
  const ClipMask allowed = allowed_clips(clips, idle, threatened);
  std::vector<int> choices;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (allowed[i]) {
      choices.push_back(static_cast<int>(i));
    }
  }
  return choices.empty() ? idle : choices[draw % choices.size()];
}

}  // namespace flinch::models
