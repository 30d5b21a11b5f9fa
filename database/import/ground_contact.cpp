// SPDX-License-Identifier: MIT
#include "database/import/ground_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flinch::database {
namespace {

constexpr double kStandingSpeed = 0.2;  // m/s
constexpr double kStandingTime = 0.1;   // s
constexpr float kStandingLift = 0.06F;  // m
constexpr double kSmoothing = 0.1;      // s, to each side

constexpr float kInTheAir = std::numeric_limits<float>::infinity();

// A point of a foot over the take, and its planted height.
struct Point {
  std::vector<Eigen::Vector3f> position;
  float planted_height = 0;

  float lift(std::size_t frame) const { return position[frame].z() - planted_height; }
};

// Lowers `lifts` to the point's lift where it stands.
void mark_standing(const Point& point, double frame_time_s, std::vector<float>& lifts) {
  const auto min_displacement = static_cast<float>(kStandingSpeed * frame_time_s);
  const auto least_frames = static_cast<std::size_t>(std::ceil(kStandingTime / frame_time_s));
  std::size_t begin = 0;
  const auto close = [&](std::size_t end) {
    if (end - begin <= least_frames) return;
    for (std::size_t k = begin; k < end; ++k) lifts[k] = std::min(lifts[k], point.lift(k));
  };
  for (std::size_t k = 0; k < point.position.size(); ++k) {
    const bool is_low = std::abs(point.lift(k)) < kStandingLift;
    const bool is_slow =
        k == begin || (point.position[k] - point.position[k - 1]).norm() < min_displacement;
    if (is_low && is_slow) continue;
    close(k);
    begin = is_low ? k : k + 1;
  }
  close(point.position.size());
}

// Fills the frames in the air: linearly between standing frames, constant before the first and
// after the last, zero if there are none.
void interpolate(std::vector<float>& lifts) {
  std::ptrdiff_t last = -1;
  const auto count = static_cast<std::ptrdiff_t>(lifts.size());
  const auto at = [&](std::ptrdiff_t k) -> float& { return lifts[static_cast<std::size_t>(k)]; };
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    if (at(k) == kInTheAir) continue;
    for (std::ptrdiff_t between = last + 1; between < k; ++between) {
      const float weight =
          last < 0 ? 1.0F : static_cast<float>(between - last) / static_cast<float>(k - last);
      at(between) = last < 0 ? at(k) : (1 - weight) * at(last) + weight * at(k);
    }
    last = k;
  }
  for (std::ptrdiff_t k = last + 1; k < count; ++k) at(k) = last < 0 ? 0.0F : at(last);
}

std::vector<float> smoothed(const std::vector<float>& values, double frame_time_s) {
  const auto reach = static_cast<std::ptrdiff_t>(std::lround(kSmoothing / frame_time_s));
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<float> result(values.size());
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    float sum = 0;
    for (std::ptrdiff_t near = k - reach; near <= k + reach; ++near) {
      sum += values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(near, 0, count - 1))];
    }
    result[static_cast<std::size_t>(k)] = sum / static_cast<float>(2 * reach + 1);
  }
  return result;
}

std::vector<float> correction(const SourceMotion& motion, std::size_t side) {
  Point ankle{{}, motion.ankle_height_m[side]};
  Point ball{{}, motion.ball_height_m[side]};
  for (const SourceFrame& frame : motion.frames) {
    ankle.position.push_back(frame.foot[side].ankle);
    ball.position.push_back(frame.foot[side].ball);
  }
  std::vector<float> lifts(motion.frames.size(), kInTheAir);
  mark_standing(ankle, motion.frame_time_s, lifts);
  mark_standing(ball, motion.frame_time_s, lifts);
  interpolate(lifts);
  return smoothed(lifts, motion.frame_time_s);
}

}  // namespace

void snap_feet_to_ground(SourceMotion& motion) {
  const std::array<std::vector<float>, 2> down{correction(motion, 0), correction(motion, 1)};
  for (std::size_t k = 0; k < motion.frames.size(); ++k) {
    SourceFrame& frame = motion.frames[k];
    for (std::size_t side = 0; side < 2; ++side) {
      frame.foot[side].ankle.z() -= down[side][k];
      frame.foot[side].ball.z() -= down[side][k];
    }
    frame.hip_centre.z() -= 0.5F * (down[0][k] + down[1][k]);
  }
}

}  // namespace flinch::database
