// SPDX-License-Identifier: MIT
#include "database/author/evasion.h"

#include <algorithm>
#include <cmath>

#include "database/rules/pose_rules.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using motion::JointFrames;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::Side;

Eigen::Quaternionf turn_of(const Eigen::Vector3f& angles) {
  return rotation_about(Eigen::Vector3f::UnitZ(), angles.z()) *
         rotation_about(Eigen::Vector3f::UnitX(), angles.x()) *
         rotation_about(Eigen::Vector3f::UnitY(), angles.y());
}

void turn_joint(Pose& pose, Role role, const Eigen::Vector3f& angles) {
  pose.rotation[role] = (pose.rotation[role] * turn_of(angles)).normalized();
}

Eigen::Vector3f toward(float azimuth) {
  return {std::cos(azimuth), std::sin(azimuth), 0};
}

// Returns the angles that tilt an upright body part towards a horizontal direction.
Eigen::Vector3f tilt(float azimuth, float angle) {
  return {-std::sin(azimuth) * angle, std::cos(azimuth) * angle, 0};
}

Pose with_arms(const motion::Figure& figure, const Pose& pose, ArmPosture manner) {
  if (manner == ArmPosture::cover) return cover_head(figure, pose);
  Pose result = pose;
  for (Side side : motion::kSides) {
    switch (manner) {
      case ArmPosture::guard:
        set_arm(result, side, {radians(38), radians(16), radians(-6), radians(112)});
        break;
      case ArmPosture::balance:
        set_arm(result, side, {radians(14), radians(42), radians(-8), radians(48)});
        break;
      case ArmPosture::hang:
      case ArmPosture::cover:
        break;
    }
  }
  return result;
}

}  // namespace

Pose balanced(const motion::Figure& figure, const motion::PerSide<motion::FootPose>& feet,
              Pose pose, ArmPosture arms) {
  constexpr float kMargin = 0.03F;
  constexpr int kRounds = 12;
  for (int round = 0;; ++round) {
    const JointFrames trunk = motion::forward_kinematics(figure.skeleton(), pose);
    pose.root_position.z() =
        std::min(pose.root_position.z(), max_pelvis_height(figure.skeleton(), trunk, feet));
    const Pose standing = with_feet(figure.skeleton(), pose, feet);
    const Pose result = with_arms(figure, standing, arms);
    const JointFrames frames = motion::forward_kinematics(figure.skeleton(), result);
    const std::vector<Eigen::Vector2f> soles =
        motion::support_polygon(figure.skeleton(), frames, 0.005F);
    const Eigen::Vector2f centre = motion::centre_of_mass(figure.bodies, frames).head<2>();
    const float lacking = kMargin - motion::signed_distance_inside(soles, centre);
    if (!(lacking > 0) || soles.empty() || round == kRounds) return result;
    Eigen::Vector2f middle = Eigen::Vector2f::Zero();
    for (const Eigen::Vector2f& point : soles) middle += point;
    middle /= static_cast<float>(soles.size());
    const Eigen::Vector2f inward = middle - centre;
    const float distance = inward.norm();
    if (distance <= 0) return result;
    pose.root_position.head<2>() += std::min(lacking, distance) / distance * inward;
  }
}

Pose evasive_pose(const motion::Figure& figure, const Pose& start, const Evasion& evasion) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const float leg = motion::limb_length(skeleton, motion::Limb::left_leg);
  const JointFrames frames = motion::forward_kinematics(skeleton, start);
  const Eigen::Quaternionf facing = rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(start));
  motion::PerSide<motion::FootPose> feet;
  for (Side side : motion::kSides) {
    feet[side] = foot_pose(frames, side);
    feet[side].ankle += facing * (leg * evasion.foot_shift[side]);
    feet[side].orientation =
        feet[side].orientation * rotation_about(Eigen::Vector3f::UnitY(), evasion.foot_pitch[side]);
  }
  Pose pose = recoil(start, evasion.shrug);
  pose.root_position += facing * (leg * evasion.pelvis_shift);
  turn_joint(pose, Role::pelvis, evasion.pelvis_turn);
  turn_joint(pose, Role::abdomen, evasion.waist_turn);
  turn_joint(pose, Role::chest, evasion.back_turn);
  turn_joint(pose, Role::neck, 0.5F * evasion.neck_turn);
  turn_joint(pose, Role::head, 0.5F * evasion.neck_turn);
  return balanced(figure, feet, pose, evasion.arms);
}

Evasion duck(float azimuth, float amount) {
  // Bends forward, and slightly away from a threat at the side.
  const float bow = radians(82) * amount;
  const float aside = -0.3F * std::sin(azimuth) * bow;
  Evasion evasion;
  evasion.pelvis_shift = {-0.12F * amount, 0, -0.32F * amount};
  evasion.pelvis_turn = {0, 0.36F * bow, 0};
  evasion.waist_turn = {-0.4F * aside, 0.34F * bow, 0};
  evasion.back_turn = {-0.6F * aside, 0.30F * bow, 0};
  evasion.neck_turn = {0, radians(18) * amount, 0};
  evasion.shrug = 0.6F * amount;
  evasion.arms = amount > 0.7F ? ArmPosture::cover : ArmPosture::guard;
  return evasion;
}

Evasion dodge(float azimuth, float sense, float amount) {
  const float way = azimuth + sense * radians(90);
  Evasion evasion;
  evasion.pelvis_shift = 0.10F * amount * toward(way) + Eigen::Vector3f(0, 0, -0.10F * amount);
  evasion.pelvis_turn = tilt(way, radians(14) * amount);
  evasion.waist_turn = tilt(way, radians(17) * amount);
  evasion.back_turn = tilt(way, radians(17) * amount);
  evasion.neck_turn = tilt(way, radians(14) * amount);
  evasion.shrug = 0.3F * amount;
  evasion.arms = ArmPosture::guard;
  return evasion;
}

Evasion sidestep(float azimuth, float sense, float amount) {
  const float way = azimuth + sense * radians(90);
  // A body is broader than it is deep, and knees bend less forward than legs spread sideways.
  const Eigen::Vector3f shift = amount * toward(way).cwiseProduct(Eigen::Vector3f(0.37F, 0.48F, 0));
  // The foot on that side steps first; for straight forward or back, the right one.
  const Side lead = std::sin(way) > 0.1F ? Side::left : Side::right;
  Evasion evasion;
  evasion.pelvis_shift = shift + Eigen::Vector3f(0, 0, -0.04F);
  evasion.waist_turn = tilt(way, radians(7) * amount);
  evasion.back_turn = tilt(way, radians(7) * amount);
  evasion.foot_shift[lead] = shift + 0.08F * toward(way);
  if (amount >= 0.5F) {
    evasion.foot_shift[other(lead)] = shift - 0.08F * toward(way);
  } else {
    evasion.foot_shift[lead] *= 1.5F;
  }
  evasion.arms = ArmPosture::guard;
  return evasion;
}

Evasion lift_leg(float azimuth, float amount) {
  // The near leg: the left for a threat from the left; the right for one straight ahead or behind.
  const Side near = std::sin(azimuth) > 0.1F ? Side::left : Side::right;
  const float near_sign = sign_of(near);
  const bool from_front = std::cos(azimuth) > -0.1F;
  Evasion evasion;
  evasion.pelvis_shift = {0, -0.17F * near_sign, -0.05F};
  evasion.pelvis_turn = {radians(8) * near_sign * amount, 0, -radians(12) * near_sign * amount};
  evasion.waist_turn = {-radians(9) * near_sign * amount, 0, 0};
  evasion.foot_shift[near] = {from_front ? -0.10F * amount : 0.22F * amount, -0.02F * near_sign,
                              (from_front ? 0.36F : 0.30F) * amount};
  evasion.foot_pitch[near] = radians(from_front ? 38 : 15) * amount;
  evasion.arms = ArmPosture::balance;
  return evasion;
}

}  // namespace flinch::database
