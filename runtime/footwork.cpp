// SPDX-License-Identifier: MIT
#include "runtime/footwork.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::runtime {
namespace {

using motion::FootPlace;
using motion::JointFrames;
using motion::Role;
using motion::Side;

constexpr float kShortest = 0.05F;  // s, of a swing and of a stand between two
constexpr float kOpening = 0.2F;    // s, in which weight is compared

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

bool touches(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& position,
             const Eigen::Quaternionf& orientation) {
  const Eigen::Vector3f up = orientation.conjugate() * Eigen::Vector3f::UnitZ();
  return std::ranges::any_of(points, [&](const Eigen::Vector3f& point) {
    return position.z() + up.dot(point) <= kStanding;
  });
}

// Whether lowest_point is within kStanding of the ground: the first point that is will do, and most
// often it is one of the foot's own.
bool stands(const motion::Skeleton& skeleton, const Sole& sole, const motion::Pose& pose,
            Side side) {
  const Role toes = motion::roles_of(side).toes;
  const FootPlace foot = foot_of(skeleton, pose, side);
  return touches(sole.foot, foot.ankle, foot.orientation) ||
         touches(sole.toes, foot.ankle + foot.orientation * skeleton.offset[toes],
                 foot.orientation * pose.rotation[toes]);
}

std::vector<Swing> swings_of(const motion::Skeleton& skeleton, const Sole& sole,
                             const motion::Motion& motion, float onset_s, Side side) {
  std::vector<Swing> swings;
  std::optional<float> left_ground_s;
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    if (time_s < onset_s) continue;
    if (!stands(skeleton, sole, motion.poses[k], side)) {
      // It left after the frame before.
      if (!left_ground_s) left_ground_s = std::max(time_s - 1 / motion.rate_hz, onset_s);
    } else if (left_ground_s) {
      close_swing(*left_ground_s, time_s, swings);
      left_ground_s.reset();
    }
  }
  if (left_ground_s) close_swing(*left_ground_s, motion.duration_s(), swings);
  std::erase_if(swings, [](const Swing& swing) { return swing.end_s - swing.begin_s < kShortest; });
  return swings;
}

// The foot nearer to the centre of mass, on average over the opening.
Side nearer_foot(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                 const motion::Motion& motion, float onset_s) {
  float nearer_to_left = 0;  // m, summed
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    if (time_s < onset_s) continue;
    if (time_s > onset_s + kOpening) break;
    const JointFrames frames = motion::forward_kinematics(skeleton, motion.poses[k]);
    const Eigen::Vector3f centre = motion::centre_of_mass(bodies, frames);
    const auto distance = [&](Side side) {
      return (motion::foot_place(frames, side).ankle - centre).head<2>().norm();
    };
    nearer_to_left += distance(Side::right) - distance(Side::left);
  }
  return nearer_to_left >= 0 ? Side::left : Side::right;
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
  Sole sole{outline.foot, outline.toes, motion::convex_hull(std::move(points)),
            Eigen::Vector2f::Zero()};
  for (const Eigen::Vector2f& corner : sole.hull)
    sole.middle += corner / static_cast<float>(sole.hull.size());
  return sole;
}

std::span<const Role> roles_to_foot(Side side) {
  static constexpr std::array kLeft{Role::pelvis, Role::left_thigh, Role::left_shin,
                                    Role::left_foot};
  static constexpr std::array kRight{Role::pelvis, Role::right_thigh, Role::right_shin,
                                     Role::right_foot};
  return side == Side::left ? kLeft : kRight;
}

FootPlace foot_of(const motion::Skeleton& skeleton, const motion::Pose& pose, Side side) {
  FootPlace place{pose.root_position, pose.rotation[Role::pelvis]};
  for (Role role : roles_to_foot(side).subspan(1)) {
    place.ankle += motion::turned(skeleton.offset[role], place.orientation);
    place.orientation = place.orientation * pose.rotation[role];
  }
  return place;
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
  const float onset_s = clip.annotation ? clip.annotation->onset_s : 0;
  const float peak_s = clip.annotation ? clip.annotation->peak_s : clip.motion.duration_s();
  Footwork footwork;
  motion::PerSide<float> first_swing_s{};
  for (Side side : motion::kSides) {
    const std::size_t i = motion::index_of(side);
    footwork.swings[i] = swings_of(skeleton, soles[i], clip.motion, onset_s, side);
    first_swing_s[i] = footwork.swings[i].empty() ? std::numeric_limits<float>::infinity()
                                                  : footwork.swings[i].front().begin_s;
  }
  if (std::min(first_swing_s[0], first_swing_s[1]) < peak_s &&
      first_swing_s[0] != first_swing_s[1]) {
    footwork.support = first_swing_s[0] > first_swing_s[1] ? Side::left : Side::right;
  } else {
    footwork.support = nearer_foot(skeleton, bodies, clip.motion, onset_s);
  }
  return footwork;
}

}  // namespace flinch::runtime
