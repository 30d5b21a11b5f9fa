// SPDX-License-Identifier: MIT
#include "runtime/footwork.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "motion/support_polygon.h"

namespace flinch::runtime {
namespace {

using motion::JointFrames;
using motion::Role;
using motion::Side;

constexpr float kShortest = 0.05F;  // s, of a swing and of a stand between two
constexpr float kOpening = 0.2F;    // s, in which weight is compared

constexpr std::array kLegs{Role::pelvis,     Role::left_thigh, Role::left_shin,
                           Role::left_foot,  Role::left_toes,  Role::right_thigh,
                           Role::right_shin, Role::right_foot, Role::right_toes};

// Adds the swing that ends at `end_s`, or joins it to the last one.
void close_swing(float begin_s, float end_s, std::vector<Swing>& swings) {
  if (!swings.empty() && begin_s - swings.back().end_s < kShortest) {
    swings.back().end_s = end_s;
  } else {
    swings.push_back({begin_s, end_s});
  }
}

float lowest_of(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& position,
                const Eigen::Quaternionf& orientation) {
  return position.z() + motion::lowest_point(points, orientation);
}

void drop_short(std::vector<Swing>& swings) {
  std::erase_if(swings, [](const Swing& swing) { return swing.end_s - swing.begin_s < kShortest; });
}

}  // namespace

Sole make_sole(const motion::Skeleton& skeleton, Side side) {
  const motion::SoleOutline outline = motion::sole_outline(skeleton, side);
  const motion::FootRoles roles = motion::roles_of(side);
  std::vector<Eigen::Vector2f> points;
  for (const Eigen::Vector3f& point : outline.foot) points.push_back(point.head<2>());
  for (const Eigen::Vector3f& point : outline.toes) {
    points.push_back((skeleton.offset[roles.toes] + point).head<2>());
  }
  return {outline.foot, outline.toes, motion::convex_hull(std::move(points))};
}

float lowest_point(const Sole& sole, const motion::FootPlace& foot, const Eigen::Quaternionf& toes,
                   const Eigen::Vector3f& toes_offset) {
  return std::min(
      lowest_of(sole.foot, foot.ankle, foot.orientation),
      lowest_of(sole.toes, foot.ankle + foot.orientation * toes_offset, foot.orientation * toes));
}

float lowest_point(const Sole& sole, const JointFrames& frames, Side side) {
  const motion::FootRoles roles = motion::roles_of(side);
  return std::min(
      lowest_of(sole.foot, frames.position[roles.foot], frames.orientation[roles.foot]),
      lowest_of(sole.toes, frames.position[roles.toes], frames.orientation[roles.toes]));
}

Footwork footwork_of(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                     const motion::PerSide<Sole>& soles, const motion::Clip& clip) {
  Footwork footwork;
  const motion::Motion& motion = clip.motion;
  const float onset_s = clip.annotation ? clip.annotation->onset_s : 0;
  const float peak_s = clip.annotation ? clip.annotation->peak_s : motion.duration_s();
  motion::PerSide<std::optional<float>> left_ground_s;
  float nearer_to_left = 0;  // m, summed over the opening
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    if (time_s < onset_s) continue;
    const bool opening = time_s <= onset_s + kOpening;  // the centre of mass is of all bodies
    const JointFrames frames = opening
                                   ? motion::forward_kinematics(skeleton, motion.poses[k])
                                   : motion::forward_kinematics(skeleton, motion.poses[k], kLegs);
    for (Side side : motion::kSides) {
      std::optional<float>& begin_s = left_ground_s[motion::index_of(side)];
      if (lowest_point(soles[motion::index_of(side)], frames, side) > kStanding) {
        // It left after the frame before.
        if (!begin_s) begin_s = std::max(time_s - 1 / motion.rate_hz, onset_s);
      } else if (begin_s) {
        close_swing(*begin_s, time_s, footwork.swings[motion::index_of(side)]);
        begin_s.reset();
      }
    }
    if (opening) {
      const Eigen::Vector3f centre = motion::centre_of_mass(bodies, frames);
      const auto distance = [&](Side side) {
        return (motion::foot_place(frames, side).ankle - centre).head<2>().norm();
      };
      nearer_to_left += distance(Side::right) - distance(Side::left);
    }
  }
  for (Side side : motion::kSides) {
    std::vector<Swing>& swings = footwork.swings[motion::index_of(side)];
    const std::optional<float>& begin_s = left_ground_s[motion::index_of(side)];
    if (begin_s) close_swing(*begin_s, motion.duration_s(), swings);
    drop_short(swings);
  }
  const auto first_swing_s = [&](Side side) {
    const std::vector<Swing>& swings = footwork.swings[motion::index_of(side)];
    return swings.empty() ? std::numeric_limits<float>::infinity() : swings.front().begin_s;
  };
  const float left_s = first_swing_s(Side::left);
  const float right_s = first_swing_s(Side::right);
  if (std::min(left_s, right_s) < peak_s && left_s != right_s) {
    footwork.support = left_s > right_s ? Side::left : Side::right;
  } else {
    footwork.support = nearer_to_left >= 0 ? Side::left : Side::right;
  }
  return footwork;
}

}  // namespace flinch::runtime
