// SPDX-License-Identifier: MIT
#include "database/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/body_distance.h"
#include "motion/error.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using motion::Body;
using motion::Clip;
using motion::degrees;
using motion::human_joint_limits;
using motion::JointFrames;
using motion::JointLimits;
using motion::limit_excess;
using motion::radians;
using motion::Role;
using motion::Side;

// Peak speeds that people reach, degrees per second. Neck: large fast head turns, 700
// (Zangemeister, Jones and Stark 1981). Trunk: pelvis against upper torso when throwing, 500
// (Fleisig et al. 1999). When throwing (the same): elbow 2300; shoulder 1500, without rotation
// about the arm's length. Clavicle: a fifth of the shoulder's. Wrist: 2000 when throwing (Debicki
// et al. 2004). Hip 1000, knee 1500, ankle 1000 when kicking (Lees and Nolan 1998). Toes: as the
// ankle.
struct SpeedRow {
  std::string_view part;  // substring of the joint's name
  float dps;
};
constexpr std::array<SpeedRow, 10> kSpeeds{{{"trunk", 500},
                                            {"neck", 700},
                                            {"clavicle", 300},
                                            {"shoulder", 1500},
                                            {"elbow", 2300},
                                            {"wrist", 2000},
                                            {"hip", 1000},
                                            {"knee", 1500},
                                            {"ankle", 1000},
                                            {"toes", 1000}}};

using FramesOfClip = std::vector<JointFrames>;

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void measure_joints(const FramesOfClip& frames, float rate_hz, ClipQuality& quality) {
  std::vector<float> excess_deg(frames.size());
  for (const JointLimits& limits : human_joint_limits()) {
    const float human_speed = radians(peak_human_speed_dps(limits.name));
    Eigen::Quaternionf before = Eigen::Quaternionf::Identity();
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const Eigen::Quaternionf rotation = relative_rotation(frames[k], limits.from, limits.to);
      excess_deg[k] = degrees(limit_excess(limits, rotation));
      if (excess_deg[k] > quality.limit_excess_deg) {
        quality.limit_excess_deg = excess_deg[k];
        quality.limit_joint = limits.name;
      }
      const float share = k == 0 ? 0 : before.angularDistance(rotation) * rate_hz / human_speed;
      before = rotation;
      if (share > quality.speed_share) {
        quality.speed_share = share;
        quality.speed_joint = limits.name;
      }
    }
    const float usual_deg = median(excess_deg);
    if (usual_deg > quality.usual_limit_excess_deg) {
      quality.usual_limit_excess_deg = usual_deg;
      quality.usual_limit_joint = limits.name;
    }
  }
}

void measure_hands(const motion::Figure& figure, const FramesOfClip& frames, ClipQuality& quality) {
  quality.hand_clearance_m = std::numeric_limits<float>::infinity();
  for (const JointFrames& pose : frames) {
    for (Body hand : {Body::left_hand, Body::right_hand}) {
      const motion::Capsule capsule = capsule_of(figure, pose, hand);
      for (Body core : motion::kCoreBodies) {
        quality.hand_clearance_m =
            std::min(quality.hand_clearance_m, distance_between(figure, pose, core, capsule));
      }
    }
  }
}

// Stores where each sole point touches the ground, and measures its slip from there until it lifts.
void measure_feet(const motion::Figure& figure, const FramesOfClip& frames, ClipQuality& quality) {
  const auto outlines = motion::sole_outlines(figure.skeleton());
  motion::PerSide<std::vector<std::optional<Eigen::Vector3f>>> landed;
  for (const JointFrames& pose : frames) {
    motion::PerSide<std::vector<Eigen::Vector3f>> soles;
    for (Side side : motion::kSides) {
      soles[side] = sole_points(outlines[side], pose, side);
      quality.foot_below_ground_m =
          std::max(quality.foot_below_ground_m, -motion::lowest_z(soles[side]));
    }
    // None in a jump.
    const std::optional<Side> support = motion::support_foot(
        motion::centre_of_mass(figure.bodies, pose),
        [&](Side side) { return motion::lowest_z(soles[side]) <= kContactHeight; },
        [&](Side side) { return motion::foot_pose(pose, side).ankle; });
    for (Side side : motion::kSides) {
      landed[side].resize(soles[side].size());
      for (std::size_t k = 0; k < soles[side].size(); ++k) {
        std::optional<Eigen::Vector3f>& first = landed[side][k];
        if (side != support || soles[side][k].z() > kContactHeight) {
          first.reset();
        } else if (!first) {
          first = soles[side][k];
        } else {
          const float slip = (soles[side][k] - *first).head<2>().norm();
          quality.support_drift_m = std::max(quality.support_drift_m, slip);
        }
      }
    }
  }
}

float balance_margin(const motion::Figure& figure, const JointFrames& frames) {
  return motion::signed_distance_inside(
      motion::support_polygon(figure.skeleton(), frames, kContactHeight),
      motion::centre_of_mass(figure.bodies, frames).head<2>());
}

void measure_balance(const motion::Figure& figure, const Clip& clip, const FramesOfClip& frames,
                     ClipQuality& quality) {
  quality.balance_margin_m =
      std::min(balance_margin(figure, frames.front()), balance_margin(figure, frames.back()));
  if (!clip.annotation) return;
  const auto peak =
      static_cast<std::size_t>(std::lround(clip.annotation->peak_s * clip.motion.rate_hz));
  quality.balance_margin_m = std::min(
      quality.balance_margin_m, balance_margin(figure, frames[std::min(peak, frames.size() - 1)]));
}

// a_k = (p_{k+1} - 2 p_k + p_{k-1}) rate^2
void measure_accelerations(const motion::Figure& figure, const FramesOfClip& frames, float rate_hz,
                           ClipQuality& quality) {
  for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
    for (Body body : motion::kBodies) {
      const auto at = [&](std::size_t i) {
        return motion::centre_of_mass(figure.bodies, frames[i], body);
      };
      const float acceleration = (at(k + 1) - 2 * at(k) + at(k - 1)).norm() * rate_hz * rate_hz;
      quality.peak_acceleration_mps2 = std::max(quality.peak_acceleration_mps2, acceleration);
    }
  }
}

}  // namespace

ClipQuality measure_quality(const motion::Figure& figure, const Clip& clip) {
  FramesOfClip frames;
  for (const motion::Pose& pose : clip.motion.poses) {
    frames.push_back(motion::forward_kinematics(figure.skeleton(), pose));
  }
  ClipQuality quality;
  quality.name = clip.name;
  measure_joints(frames, clip.motion.rate_hz, quality);
  measure_hands(figure, frames, quality);
  measure_feet(figure, frames, quality);
  measure_balance(figure, clip, frames, quality);
  measure_accelerations(figure, frames, clip.motion.rate_hz, quality);
  return quality;
}

ClipQuality measure_joints_and_feet(const motion::Figure& figure, const Clip& clip, float rate_hz) {
  const auto step =
      static_cast<std::size_t>(std::max(1L, std::lround(clip.motion.rate_hz / rate_hz)));
  FramesOfClip frames;
  for (std::size_t k = 0; k < clip.motion.poses.size(); k += step) {
    frames.push_back(motion::forward_kinematics(figure.skeleton(), clip.motion.poses[k]));
  }
  ClipQuality quality;
  quality.name = clip.name;
  measure_joints(frames, clip.motion.rate_hz / static_cast<float>(step), quality);
  measure_feet(figure, frames, quality);
  return quality;
}

std::vector<ClipQuality> measure_quality(const ClipLibrary& library) {
  const motion::Figure figure = motion::make_figure(library.character);
  std::vector<ClipQuality> table;
  for (const Clip& clip : library.clips) table.push_back(measure_quality(figure, clip));
  return table;
}

std::vector<std::string> broken_bounds(const ClipQuality& quality, const QualityBounds& bounds) {
  std::vector<std::string> broken;
  const auto check = [&broken](bool kept, const char* name) {
    if (!kept) broken.emplace_back(name);
  };
  check(quality.limit_excess_deg <= bounds.limit_excess_deg, "limit_excess_deg");
  check(quality.hand_clearance_m >= bounds.hand_clearance_m, "hand_clearance_m");
  check(quality.support_drift_m <= bounds.support_drift_m, "support_drift_m");
  check(quality.foot_below_ground_m <= bounds.foot_below_ground_m, "foot_below_ground_m");
  check(quality.balance_margin_m >= bounds.balance_margin_m, "balance_margin_m");
  check(quality.speed_share <= bounds.speed_share, "speed_share");
  check(quality.peak_acceleration_mps2 <= bounds.peak_acceleration_mps2, "peak_acceleration_mps2");
  return broken;
}

float peak_human_speed_dps(std::string_view joint) {
  for (const SpeedRow& row : kSpeeds) {
    if (joint.ends_with(row.part)) return row.dps;
  }
  throw Error("", "there is no peak speed for a joint '" + std::string(joint) + "'");
}

}  // namespace flinch::database
