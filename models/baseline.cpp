// SPDX-License-Identifier: MIT
#include "models/baseline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "motion/rotation.h"

namespace flinch::models {

std::vector<int> nearest_annotations(std::span<const ClipSummary> clips, int idle,
                                     motion::Target threatened, float azimuth) {
  const ClipMask allowed = allowed_clips(clips, idle, threatened);
  std::vector<std::tuple<bool, double, int>> ranked;  // other target, angle, clip
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!allowed[i] || static_cast<int>(i) == idle || !clips[i].annotation) continue;
    const motion::Annotation& annotation = *clips[i].annotation;
    const double angle = std::abs(motion::wrapped_to_pi(static_cast<double>(annotation.direction) -
                                                        static_cast<double>(azimuth)));
    ranked.emplace_back(annotation.target != threatened, angle, static_cast<int>(i));
  }
  std::ranges::sort(ranked);
  std::vector<int> nearest;
  for (const auto& [other_target, angle, clip] : ranked) nearest.push_back(clip);
  if (nearest.empty()) nearest.push_back(idle);
  return nearest;
}

int nearest_annotation(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       float azimuth) {
  return nearest_annotations(clips, idle, threatened, azimuth).front();
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
