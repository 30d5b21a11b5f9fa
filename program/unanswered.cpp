// SPDX-License-Identifier: MIT
#include "program/unanswered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::program {
namespace {

bool is_for(const models::ClipSummary& clip, motion::Target target) {
  return clip.annotation && clip.annotation->target == target;
}

/// Whether one of the clips of a target is made for this direction (radians) or its neighbour.
bool is_answered(std::span<const models::ClipSummary> clips, motion::Target target,
                 double direction) {
  constexpr double kNeighbour = std::numbers::pi / 4 + 0.01;
  return std::ranges::any_of(clips, [&](const models::ClipSummary& clip) {
    return is_for(clip, target) &&
           std::abs(motion::wrapped_to_pi(double{clip.annotation->direction} - direction)) <
               kNeighbour;
  });
}

}  // namespace

std::vector<std::string> unanswered(std::span<const models::ClipSummary> clips) {
  std::vector<std::string> lines;
  for (const motion::Target target : motion::kTargets) {
    const std::string name(motion::name_of(target));
    if (std::ranges::none_of(clips, [&](const auto& clip) { return is_for(clip, target); })) {
      lines.push_back("no clip is made for threats to the " + name);
      continue;
    }
    std::string directions;
    for (const int degrees : {0, 45, 90, 135, 180, -135, -90, -45}) {
      if (is_answered(clips, target, motion::radians(static_cast<double>(degrees)))) continue;
      directions += (directions.empty() ? "" : ", ") + std::to_string(degrees);
    }
    if (!directions.empty())
      lines.push_back("no clip is made for threats to the " + name + " from " + directions +
                      " degrees");
  }
  return lines;
}

}  // namespace flinch::program
