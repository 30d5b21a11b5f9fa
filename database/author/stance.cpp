// SPDX-License-Identifier: MIT
#include "database/author/stance.h"

#include <cmath>

#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::JointFrames;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::Side;

constexpr float kTurnOut = radians(8);
constexpr float kIdle = 8;  // s, a whole number of breaths

motion::PerSide<motion::FootPose> feet_at(const motion::Figure& figure, float forward_m,
                                          float half_between_m) {
  const float ankle_height = motion::measure_foot(figure.skeleton(), Side::left).ankle_height;
  motion::PerSide<motion::FootPose> feet;
  for (Side side : motion::kSides) {
    feet[side] = {{forward_m, sign_of(side) * half_between_m, ankle_height},
                  rotation_about(Eigen::Vector3f::UnitZ(), sign_of(side) * kTurnOut)};
  }
  return feet;
}

// Displacements in `idle_motion`, each 0 at both ends.
struct Sway {
  float breath;    // 0 exhaled, 1 inhaled
  float sideways;  // -1 to 1
  float forward;
};

// 1 - cos and its derivative are 0 where the argument is a whole number of turns.
Sway sway_at(float time_s) {
  const float turn = 2 * std::numbers::pi_v<float> * time_s / kIdle;
  return {0.5F * (1 - std::cos(2 * turn)), 0.5F * (std::cos(2 * turn) - std::cos(turn)),
          0.5F * (std::cos(3 * turn) - std::cos(turn))};
}

// Of the guard, at one moment of its cycle; shares of the stature and radians.
struct GuardSway {
  float forward;
  float down;
  float fists;
};

constexpr float kGuardCycle_s = 2;

GuardSway guard_sway_at(float time_s) {
  const float turn = 2 * std::numbers::pi_v<float> * time_s / kGuardCycle_s;
  return {0.012F * std::sin(turn), 0.004F * (1 - std::cos(2 * turn)), 0.008F * std::sin(2 * turn)};
}

motion::PerSide<motion::FootPose> guard_feet(const motion::Figure& figure) {
  const float height = stature(figure.skeleton());
  const float ankle_height = motion::measure_foot(figure.skeleton(), Side::left).ankle_height;
  const auto foot = [&](float forward, float left, float turn) -> motion::FootPose {
    return {{forward * height, left * height, ankle_height},
            rotation_about(Eigen::Vector3f::UnitZ(), turn)};
  };
  return {{{foot(0.11F, 0.05F, radians(-12)), foot(-0.13F, -0.06F, radians(-52))}}};
}

// Forearms rise from elbows at the ribs to fists before the chin.
void set_fists(const motion::Figure& figure, const GuardSway& sway, Pose& pose) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const float height = stature(skeleton);
  const JointFrames trunk = motion::forward_kinematics(skeleton, pose);
  for (Side side : motion::kSides) {
    const float forward = side == Side::left ? 0.19F : 0.13F;
    const Eigen::Vector3f from_head =
        height * Eigen::Vector3f(forward + sway.fists, sign_of(side) * 0.045F, -0.035F);
    solve_arm(skeleton, trunk, side,
              {trunk.position[Role::head] + from_head, -Eigen::Vector3f::UnitZ(), radians(20)},
              pose);
  }
}

}  // namespace

Pose standing_pose(const motion::Figure& figure) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const float height = stature(skeleton);
  Pose pose = motion::rest_pose(skeleton);
  pose.root_position.z() -= 0.008F * height;  // bends the knees a little
  pose.rotation[Role::abdomen] = rotation_about(Eigen::Vector3f::UnitY(), radians(2));
  pose.rotation[Role::neck] = rotation_about(Eigen::Vector3f::UnitY(), radians(4));
  pose.rotation[Role::head] = rotation_about(Eigen::Vector3f::UnitY(), radians(-5));
  for (Side side : motion::kSides) {
    set_arm(pose, side, {radians(2), radians(9), radians(-10), radians(18)});
  }
  // The middle of the sole is a fifth of the foot's length in front of the ankle.
  const float forward = -0.2F * motion::measure_foot(skeleton, Side::left).length;
  const float half_between = skeleton.offset[Role::left_thigh].y() + 0.012F * height;
  Pose standing = with_feet(skeleton, pose, feet_at(figure, forward, half_between));
  const Eigen::Vector3f centre =
      motion::centre_of_mass(figure.bodies, motion::forward_kinematics(skeleton, standing));
  return with_feet(skeleton, pose, feet_at(figure, forward + centre.x(), half_between));
}

motion::Motion idle_motion(const motion::Figure& figure, float rate_hz) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const float height = stature(skeleton);
  const Pose standing = standing_pose(figure);
  const JointFrames frames = motion::forward_kinematics(skeleton, standing);
  const motion::PerSide<motion::FootPose> feet{foot_pose(frames, Side::left),
                                               foot_pose(frames, Side::right)};

  motion::Motion idle;
  idle.rate_hz = rate_hz;
  const int count = static_cast<int>(std::lround(kIdle * rate_hz)) + 1;
  for (int k = 0; k < count; ++k) {
    const Sway sway = sway_at(static_cast<float>(k) / rate_hz);
    Pose pose = standing;
    pose.root_position +=
        height * Eigen::Vector3f(0.003F * sway.forward, 0.005F * sway.sideways, 0);
    const float lift = radians(1.2F) * sway.breath;
    pose.rotation[Role::chest] =
        pose.rotation[Role::chest] * rotation_about(Eigen::Vector3f::UnitY(), -lift);
    pose.rotation[Role::neck] =
        pose.rotation[Role::neck] * rotation_about(Eigen::Vector3f::UnitY(), 0.8F * lift);
    pose.rotation[Role::abdomen] =
        pose.rotation[Role::abdomen] *
        rotation_about(Eigen::Vector3f::UnitX(), radians(1) * sway.sideways);
    for (Side side : motion::kSides) {
      const Role clavicle = side == Side::left ? Role::left_clavicle : Role::right_clavicle;
      pose.rotation[clavicle] =
          rotation_about(Eigen::Vector3f::UnitX(), sign_of(side) * 1.5F * lift);
    }
    idle.poses.push_back(with_feet(skeleton, pose, feet));
  }
  return idle;
}

motion::Motion guard_motion(const motion::Figure& figure, float rate_hz) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const float height = stature(skeleton);
  Pose guard = motion::rest_pose(skeleton);
  guard.root_position.z() -= 0.05F * height;  // bends the knees
  const auto turn = [&guard](Role role, const Eigen::Vector3f& axis, float degrees) {
    guard.rotation[role] = guard.rotation[role] * rotation_about(axis, radians(degrees));
  };
  turn(Role::pelvis, Eigen::Vector3f::UnitZ(), -32);
  turn(Role::abdomen, Eigen::Vector3f::UnitY(), 6);
  turn(Role::chest, Eigen::Vector3f::UnitY(), 6);
  turn(Role::neck, Eigen::Vector3f::UnitZ(), 16);
  turn(Role::head, Eigen::Vector3f::UnitZ(), 16);
  turn(Role::head, Eigen::Vector3f::UnitY(), -4);
  for (Side side : motion::kSides) set_arm(guard, side, {});
  const motion::PerSide<motion::FootPose> feet = guard_feet(figure);

  motion::Motion motion;
  motion.rate_hz = rate_hz;
  const int count = static_cast<int>(std::lround(kGuardCycle_s * rate_hz));
  for (int k = 0; k < count; ++k) {
    const GuardSway sway = guard_sway_at(static_cast<float>(k) / rate_hz);
    Pose pose = guard;
    pose.root_position += height * Eigen::Vector3f(sway.forward, 0, -sway.down);
    set_fists(figure, sway, pose);
    motion.poses.push_back(with_feet(skeleton, pose, feet));
  }
  motion.poses.push_back(motion.poses.front());
  return motion;
}

}  // namespace flinch::database
