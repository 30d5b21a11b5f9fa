// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "features/ball.h"
#include "motion/default_character.h"
#include "motion/interpolation.h"
#include "motion/mirror.h"
#include "sim/simulation_options.h"

// Procedural motions and aimed balls, for the tests, the study and the benchmark of the simulation.
namespace flinch::scenes {

constexpr float kDegrees = 3.14159265F / 180;

inline void turn(motion::Pose& pose, motion::Role role, const Eigen::Vector3f& axis,
                 float degrees) {
  const Eigen::Quaternionf rotation(Eigen::AngleAxisf(degrees * kDegrees, axis));
  pose.rotation[role] = pose.rotation[role] * rotation;
}

/// Standing with the arms hanging down.
inline motion::Pose standing(const motion::Skeleton& skeleton) {
  motion::Pose pose = motion::rest_pose(skeleton);
  turn(pose, motion::Role::left_upper_arm, Eigen::Vector3f::UnitX(), -80);
  turn(pose, motion::Role::right_upper_arm, Eigen::Vector3f::UnitX(), 80);
  return pose;
}

/// Knees bent by `degrees`, soles flat on the ground.
inline motion::Pose squatting(const motion::Skeleton& skeleton, float degrees) {
  motion::Pose pose = standing(skeleton);
  const float before = forward_kinematics(skeleton, pose).position[motion::Role::left_foot].z();
  for (const auto& [thigh, shin, foot] :
       {std::tuple{motion::Role::left_thigh, motion::Role::left_shin, motion::Role::left_foot},
        {motion::Role::right_thigh, motion::Role::right_shin, motion::Role::right_foot}}) {
    turn(pose, thigh, Eigen::Vector3f::UnitY(), -degrees / 2);
    turn(pose, shin, Eigen::Vector3f::UnitY(), degrees);
    turn(pose, foot, Eigen::Vector3f::UnitY(), -degrees / 2);
  }
  turn(pose, motion::Role::abdomen, Eigen::Vector3f::UnitY(), degrees / 4);
  const float after = forward_kinematics(skeleton, pose).position[motion::Role::left_foot].z();
  pose.root_position.z() += before - after;
  return pose;
}

/// Both hands before the face.
inline motion::Pose guarding(const motion::Skeleton& skeleton) {
  motion::Pose pose = motion::rest_pose(skeleton);
  for (const auto& [upper_arm, forearm, side] :
       {std::tuple{motion::Role::left_upper_arm, motion::Role::left_forearm, 1.0F},
        {motion::Role::right_upper_arm, motion::Role::right_forearm, -1.0F}}) {
    turn(pose, upper_arm, Eigen::Vector3f::UnitZ(), -side * 85);
    turn(pose, upper_arm, Eigen::Vector3f::UnitX(), -side * 40);
    turn(pose, forearm, Eigen::Vector3f::UnitX(), side * 135);
    turn(pose, forearm, Eigen::Vector3f::UnitZ(), -side * 20);
  }
  return pose;
}

inline motion::Pose stepped_aside(const motion::Skeleton& skeleton) {
  motion::Pose pose = standing(skeleton);
  pose.root_position += Eigen::Vector3f(0, 0.35F, -0.02F);
  turn(pose, motion::Role::left_thigh, Eigen::Vector3f::UnitX(), 15);
  turn(pose, motion::Role::left_foot, Eigen::Vector3f::UnitX(), -15);
  turn(pose, motion::Role::abdomen, Eigen::Vector3f::UnitX(), -15);
  return pose;
}

inline motion::Pose arms_raised(const motion::Skeleton& skeleton) {
  motion::Pose pose = motion::rest_pose(skeleton);
  turn(pose, motion::Role::left_upper_arm, Eigen::Vector3f::UnitX(), 60);
  turn(pose, motion::Role::right_upper_arm, Eigen::Vector3f::UnitX(), -60);
  return pose;
}

/// From one pose to another within `rise_s`, starting at 0.2 s, and then held; one second at 60 Hz.
inline motion::Motion between(const motion::Pose& from, const motion::Pose& to, float rise_s) {
  motion::Motion motion;
  for (int k = 0; k <= 60; ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    motion.poses.push_back(
        motion::blend(from, to, motion::ease_in_ease_out((time_s - 0.2F) / rise_s)));
  }
  return motion;
}

/// The same, down into a squat of `degrees`, soles on the ground throughout.
inline motion::Motion squat(const motion::Skeleton& skeleton, float degrees, float fall_s) {
  motion::Motion motion;
  for (int k = 0; k <= 60; ++k) {
    const float time_s = static_cast<float>(k) / motion.rate_hz;
    const float depth = motion::ease_in_ease_out((time_s - 0.2F) / fall_s);
    motion.poses.push_back(squatting(skeleton, depth * degrees));
  }
  return motion;
}

struct NamedMotion {
  std::string name;
  motion::Motion motion;
};

inline std::vector<NamedMotion> motions_by_rule(const motion::Skeleton& skeleton) {
  const motion::Pose stand = standing(skeleton);
  return {{"stand", between(stand, stand, 0.5F)},
          {"squat", squat(skeleton, 90, 0.5F)},
          {"fast duck", squat(skeleton, 100, 0.25F)},
          {"side step", between(stand, stepped_aside(skeleton), 0.5F)},
          {"arm raise", between(stand, arms_raised(skeleton), 0.4F)},
          {"fast block", between(stand, guarding(skeleton), 0.2F)}};
}

/// A volleyball that is at `place` at `time_s` if nothing stops it, flying along `velocity` there.
inline features::Ball aimed_ball(const Eigen::Vector3d& place, const Eigen::Vector3d& velocity,
                                 double time_s) {
  features::Ball ball;
  const double gravity = sim::SimulationOptions{}.gravity_mps2;
  ball.velocity = velocity + Eigen::Vector3d(0, 0, gravity * time_s);
  ball.position = place - velocity * time_s - Eigen::Vector3d(0, 0, gravity * time_s * time_s / 2);
  return ball;
}

}  // namespace flinch::scenes
