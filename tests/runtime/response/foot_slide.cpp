// SPDX-License-Identifier: MIT
#include "tests/runtime/response/foot_slide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "runtime/response/prepared_library.h"

namespace flinch::tests {
namespace {

using motion::Side;
using Points = std::vector<Eigen::Vector3f>;

constexpr float kRate_hz = 120;
constexpr float kOnGround_m = 0.004F;

/// By how much a sole slides from one moment to the next; none if it is off the ground.
std::optional<float> slide_between(const Points& before, const Points& now) {
  float least_m = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (std::max(before[i].z(), now[i].z()) > kOnGround_m) continue;
    least_m = std::min(least_m, (now[i] - before[i]).head<2>().norm());
  }
  if (!std::isfinite(least_m)) return std::nullopt;
  return least_m;
}

template <class PoseAt>
FootSlide longest(const runtime::PreparedLibrary& library, const PoseAt& pose_at, float from_s,
                  float to_s) {
  FootSlide most;
  const auto soles_at = [&](float time_s) {
    const motion::JointFrames frames =
        motion::forward_kinematics(library.skeleton(), pose_at(time_s));
    motion::PerSide<Points> soles;
    for (Side side : motion::kSides)
      soles[side] = motion::sole_points(library.soles[side], frames, side);
    return soles;
  };
  motion::PerSide<Points> before = soles_at(from_s);
  motion::PerSide<FootSlide> stand;
  for (Side side : motion::kSides) stand[side] = {0, from_s, from_s, side};
  for (int k = 1; from_s + static_cast<float>(k) / kRate_hz <= to_s; ++k) {
    const float time_s = from_s + static_cast<float>(k) / kRate_hz;
    const motion::PerSide<Points> now = soles_at(time_s);
    for (Side side : motion::kSides) {
      if (const auto slide_m = slide_between(before[side], now[side])) {
        stand[side].way_m += *slide_m;
        stand[side].to_s = time_s;
        if (stand[side].way_m > most.way_m) most = stand[side];
      } else {
        stand[side] = {0, time_s, time_s, side};
      }
    }
    before = now;
  }
  return most;
}

}  // namespace

FootSlide longest_slide(const runtime::Response& response, float from_s, float to_s) {
  return longest(
      *response.library, [&](float t) { return runtime::pose_at(response, t); }, from_s, to_s);
}

FootSlide longest_slide(const runtime::PreparedLibrary& library,
                        const features::CharacterState& state, float to_s) {
  const motion::Loop& loop = library.stance_of(state).loop;
  return longest(
      library, [&](float t) { return features::idle_pose(loop, state, t); }, 0, to_s);
}

}  // namespace flinch::tests
