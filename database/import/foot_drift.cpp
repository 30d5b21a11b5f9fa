// SPDX-License-Identifier: MIT
#include "database/import/foot_drift.h"

#include <algorithm>
#include <array>
#include <vector>

#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using motion::Role;

constexpr float kPlantedHeight = 0.03F;  // m above the flat foot's
constexpr float kPlantedSpeed = 0.2F;    // m/s
constexpr float kPlantedTime = 0.1F;     // s

// One point of a foot over the clip: its horizontal position in the source and in the retargeted
// clip, and its height above its planted height in the source.
struct PointTrajectory {
  std::vector<Vector2f> source, clip;
  std::vector<float> height;
};

void measure_plant(const PointTrajectory& track, std::size_t begin, std::size_t end,
                   float interval_s, FootDrift& drift) {
  const float duration = static_cast<float>(end - begin - 1) * interval_s;
  if (end <= begin + 1 || duration < kPlantedTime) return;
  drift.planted_s += duration;
  for (std::size_t k = begin; k < end; ++k) {
    const Vector2f source_way = track.source[k] - track.source[begin];
    const Vector2f clip_way = track.clip[k] - track.clip[begin];
    drift.source_m = std::max(drift.source_m, source_way.norm());
    drift.added_m = std::max(drift.added_m, (clip_way - source_way).norm());
  }
}

void measure_track(const PointTrajectory& track, float interval_s, FootDrift& drift) {
  std::size_t begin = 0;
  for (std::size_t k = 0; k < track.source.size(); ++k) {
    const bool is_low = track.height[k] < kPlantedHeight;
    const bool is_slow =
        k == begin || (track.source[k] - track.source[k - 1]).norm() < kPlantedSpeed * interval_s;
    if (is_low && is_slow) continue;
    measure_plant(track, begin, k, interval_s, drift);
    begin = is_low ? k : k + 1;
  }
  measure_plant(track, begin, track.source.size(), interval_s, drift);
}

}  // namespace

FootDrift measure_foot_drift(const SourceMotion& source, const motion::Skeleton& skeleton,
                             const Segment& segment, const motion::Motion& clip) {
  const float scale = leg_ratio(source, skeleton);
  const Placement placement = placement_of(source, skeleton, segment);
  const Eigen::Rotation2Df turn(placement.yaw);
  const motion::PerSide<motion::SoleOutline> soles = motion::sole_outlines(skeleton);
  float lowest_sole = std::numeric_limits<float>::infinity();
  std::array<std::array<PointTrajectory, 2>, 2> tracks;  // side, then ankle and ball
  for (std::size_t k = 0; k < clip.poses.size(); ++k) {
    const double time_s =
        segment.start_s + static_cast<double>(k) / static_cast<double>(clip.rate_hz);
    const SourceFrame frame = sample(source, std::min(time_s, segment.end_s));
    const motion::JointFrames frames = forward_kinematics(skeleton, clip.poses[k]);
    for (motion::Side side : motion::kSides) {
      lowest_sole =
          std::min(lowest_sole, motion::lowest_z(motion::sole_points(soles[side], frames, side)));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const motion::FootRoles roles =
          motion::roles_of(side == 0 ? motion::Side::left : motion::Side::right);
      const auto add = [&](PointTrajectory& track, const Vector3f& point, float planted_height,
                           Role role) {
        track.source.push_back(turn * (scale * point.head<2>()));
        track.clip.push_back(frames.position[role].head<2>());
        track.height.push_back(scale * (point.z() - planted_height));
      };
      const SourceFoot& foot = frame.foot[side];
      add(tracks[side][0], foot.ankle, source.ankle_height_m[side], roles.foot);
      add(tracks[side][1], foot.ball, source.ball_height_m[side], roles.toes);
    }
  }
  FootDrift drift;
  for (const auto& side : tracks) {
    for (const PointTrajectory& track : side) measure_track(track, 1 / clip.rate_hz, drift);
  }
  drift.lowest_sole_m = lowest_sole;
  return drift;
}

}  // namespace flinch::database
