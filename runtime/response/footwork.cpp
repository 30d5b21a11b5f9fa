// SPDX-License-Identifier: MIT
#include "runtime/response/footwork.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "motion/limb_ik.h"
#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::JointFrames;
using motion::Role;
using motion::Side;

constexpr float kMinSwing_s = 0.05F;  // s, shortest swing, and shortest stance between two swings
constexpr float kOpening_s = 0.2F;    // s, time over which weight is compared

float onset_of(const motion::Clip& clip) {
  return clip.annotation ? clip.annotation->onset_s : 0;
}

// Adds the swing that ends at `end_s`, or merges it with the last swing.
void close_swing(float begin_s, float end_s, std::vector<Swing>& swings) {
  if (!swings.empty() && begin_s - swings.back().end_s < kMinSwing_s) {
    swings.back().end_s = end_s;
  } else {
    swings.push_back({begin_s, end_s});
  }
}

float lowest_of(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& position,
                const Eigen::Quaternionf& orientation) {
  return position.z() + motion::min_height(points, orientation);
}

bool touches(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& position,
             const Eigen::Quaternionf& orientation) {
  const Eigen::Vector3f up = orientation.conjugate() * Eigen::Vector3f::UnitZ();
  return std::ranges::any_of(points, [&](const Eigen::Vector3f& point) {
    return position.z() + up.dot(point) <= kMaxStandingHeight_m;
  });
}

// Whether min_height is within kMaxStandingHeight_m of the ground. Stops at the first point that
// is, which is usually one of the foot's own.
bool stands(const motion::Skeleton& skeleton, const Sole& sole, const motion::Pose& pose,
            Side side) {
  const Role toes = motion::roles_of(side).toes;
  const FootPose foot = foot_of(skeleton, pose, side);
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
      // It left the ground after the frame before.
      if (!left_ground_s) left_ground_s = std::max(time_s - 1 / motion.rate_hz, onset_s);
    } else if (left_ground_s) {
      close_swing(*left_ground_s, time_s, swings);
      left_ground_s.reset();
    }
  }
  if (left_ground_s) close_swing(*left_ground_s, motion.duration_s(), swings);
  std::erase_if(swings,
                [](const Swing& swing) { return swing.end_s - swing.begin_s < kMinSwing_s; });
  return swings;
}

// Returns the foot that is nearer to the centre of mass, on average over the opening.
Side nearer_foot(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                 const motion::Motion& motion, float onset_s) {
  float nearer_to_left = 0;  // m, sum over the poses
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    if (time_s < onset_s) continue;
    if (time_s > onset_s + kOpening_s) break;
    const JointFrames frames = motion::forward_kinematics(skeleton, motion.poses[k]);
    const Eigen::Vector3f centre = motion::centre_of_mass(bodies, frames);
    const auto distance = [&](Side side) {
      return (motion::foot_pose(frames, side).ankle - centre).head<2>().norm();
    };
    nearer_to_left += distance(Side::right) - distance(Side::left);
  }
  return nearer_to_left >= 0 ? Side::left : Side::right;
}

}  // namespace

Sole make_sole(const motion::Skeleton& skeleton, Side side) {
  motion::SoleOutline outline = motion::sole_outline(skeleton, side);
  const motion::FootRoles roles = motion::roles_of(side);
  std::vector<Eigen::Vector2f> points;
  for (const Eigen::Vector3f& point : outline.foot) points.push_back(point.head<2>());
  for (const Eigen::Vector3f& point : outline.toes) {
    points.push_back((skeleton.offset[roles.toes] + point).head<2>());
  }
  Sole sole{std::move(outline), motion::convex_hull(std::move(points))};
  for (const Eigen::Vector2f& corner : sole.hull)
    sole.middle += corner / static_cast<float>(sole.hull.size());
  return sole;
}

std::span<const Role> leg_chain(Side side) {
  static constexpr std::array kLeft{Role::pelvis, Role::left_thigh, Role::left_shin,
                                    Role::left_foot};
  static constexpr std::array kRight{Role::pelvis, Role::right_thigh, Role::right_shin,
                                     Role::right_foot};
  return side == Side::left ? kLeft : kRight;
}

FootPose foot_of(const motion::Skeleton& skeleton, const motion::Pose& pose, Side side) {
  FootPose place{pose.root_position, pose.rotation[Role::pelvis]};
  for (Role role : leg_chain(side).subspan(1)) {
    place.ankle += motion::rotated(skeleton.offset[role], place.orientation);
    place.orientation = place.orientation * pose.rotation[role];
  }
  return place;
}

float min_height(const Sole& sole, const motion::FootPose& foot, const Eigen::Quaternionf& toes,
                 const Eigen::Vector3f& toes_offset) {
  return std::min(
      lowest_of(sole.foot, foot.ankle, foot.orientation),
      lowest_of(sole.toes, foot.ankle + foot.orientation * toes_offset, foot.orientation * toes));
}

float min_height(const Sole& sole, const JointFrames& frames, Side side) {
  const motion::FootRoles roles = motion::roles_of(side);
  return std::min(
      lowest_of(sole.foot, frames.position[roles.foot], frames.orientation[roles.foot]),
      lowest_of(sole.toes, frames.position[roles.toes], frames.orientation[roles.toes]));
}

Footwork footwork_of(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                     const motion::PerSide<Sole>& soles, const motion::Clip& clip) {
  const float onset_s = onset_of(clip);
  const float peak_s = clip.annotation ? clip.annotation->peak_s : clip.motion.duration_s();
  Footwork footwork;
  motion::PerSide<float> first_swing_s{};
  for (Side side : motion::kSides) {
    footwork.swings[side] = swings_of(skeleton, soles[side], clip.motion, onset_s, side);
    first_swing_s[side] = footwork.swings[side].empty() ? std::numeric_limits<float>::infinity()
                                                        : footwork.swings[side].front().begin_s;
  }
  const float left_s = first_swing_s[Side::left];
  const float right_s = first_swing_s[Side::right];
  if (std::min(left_s, right_s) < peak_s && left_s != right_s) {
    footwork.support = left_s > right_s ? Side::left : Side::right;
  } else {
    footwork.support = nearer_foot(skeleton, bodies, clip.motion, onset_s);
  }
  return footwork;
}

bool is_sound(const Footwork& footwork, const motion::Clip& clip) {
  const float onset_s = onset_of(clip);
  const float duration_s = clip.motion.duration_s();
  const auto are_sound = [=](const std::vector<Swing>& swings) {
    for (std::size_t i = 0; i < swings.size(); ++i) {
      const auto [begin_s, end_s] = swings[i];
      const bool in_order =
          i == 0 ? begin_s >= onset_s : begin_s - swings[i - 1].end_s >= kMinSwing_s;
      // Also false for not-a-number.
      if (!in_order || !(end_s - begin_s >= kMinSwing_s && end_s <= duration_s)) return false;
    }
    return true;
  };
  return footwork.support <= Side::right && std::ranges::all_of(footwork.swings, are_sound);
}

}  // namespace flinch::runtime
