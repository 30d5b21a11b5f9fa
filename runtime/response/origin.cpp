// SPDX-License-Identifier: MIT
#include "runtime/response/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;

// A sole this near to the ground stands on it: games' ground and ours may differ a little.
constexpr float kStandsBelow = 0.02F;  // m

Eigen::Vector3f turn_between(const Pose& idle, const Pose& pose, Role role) {
  return motion::rotation_vector(pose.rotation[role] * idle.rotation[role].conjugate());
}

Eigen::Vector3f settled(const Eigen::Vector3f& x, const Eigen::Vector3f& v, float time_s,
                        float decay) {
  return (x + (v + kSettling * x) * time_s) * decay;
}

}  // namespace

// Feet say which way a body stands: a pelvis turns with what the body does. Those in the air count
// only where none stands.
features::CharacterState state_under(const PreparedLibrary& library, const Pose& pose) {
  const motion::Skeleton& skeleton = library.skeleton();
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
  const motion::JointFrames idle =
      motion::forward_kinematics(skeleton, library.idle().poses.front());
  const Eigen::Vector3f centre = motion::centre_of_mass(library.bodies, frames);
  motion::PerSide<float> height{};
  motion::PerSide<float> distance{};
  for (motion::Side side : motion::kSides) {
    const std::size_t i = motion::index_of(side);
    height[i] = lowest_point(library.soles[i], frames, side);
    distance[i] = (motion::foot_place(frames, side).ankle - centre).head<2>().norm();
  }
  const float standing = std::max(kStandsBelow, std::min(height[0], height[1]));
  Eigen::Vector2f heading = Eigen::Vector2f::Zero();
  motion::Side support = motion::Side::left;
  float nearest = std::numeric_limits<float>::infinity();
  for (motion::Side side : motion::kSides) {
    const std::size_t i = motion::index_of(side);
    if (height[i] > standing) continue;
    const Eigen::Quaternionf turn = motion::foot_place(frames, side).orientation *
                                    motion::foot_place(idle, side).orientation.conjugate();
    heading += (turn * Eigen::Vector3f::UnitX()).head<2>();
    if (distance[i] < nearest) {
      nearest = distance[i];
      support = side;
    }
  }
  features::CharacterState state;
  state.facing = std::atan2(heading.y(), heading.x());
  const Eigen::Quaternionf facing = motion::turn_about(Eigen::Vector3f::UnitZ(), state.facing);
  state.position =
      (motion::foot_place(frames, support).ankle - facing * motion::foot_place(idle, support).ankle)
          .head<2>();
  return state;
}

Origin make_origin(const PreparedLibrary& library, const features::CharacterState& state,
                   const Pose& before, const Pose& now, float dt_s) noexcept {
  constexpr float kTurn = std::numbers::pi_v<float>;
  Origin origin;
  origin.idles = false;
  const bool moves = dt_s > 0;
  const Pose idle = features::idle_pose(library.idle(), state, 0);
  const Pose idle_before = features::idle_pose(library.idle(), state, moves ? -dt_s : 0);
  origin.root = now.root_position - idle.root_position;
  if (moves) {
    origin.root_velocity =
        (origin.root - (before.root_position - idle_before.root_position)) / dt_s;
  }
  for (Role role : motion::kRoles) {
    origin.turn[role] = turn_between(idle, now, role);
    const Eigen::Vector3f change = origin.turn[role] - turn_between(idle_before, before, role);
    // Vectors of almost half a turn may change sides between two poses: that is no velocity.
    origin.turn_velocity[role] =
        moves && change.norm() < kTurn ? Eigen::Vector3f(change / dt_s) : Eigen::Vector3f::Zero();
  }
  const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), now);
  for (motion::Side side : motion::kSides) {
    const std::size_t i = motion::index_of(side);
    origin.stands[i] = lowest_point(library.soles[i], frames, side) < kStandsBelow;
    origin.foot[i] = motion::foot_place(frames, side);
  }
  return origin;
}

Pose pose_from(const PreparedLibrary& library, const features::CharacterState& state,
               const Origin& origin, float time_s, std::span<const Role> roles) noexcept {
  Pose pose = features::idle_pose(library.idle(), state, time_s, roles);
  if (origin.idles) return pose;
  const float decay = std::exp(-kSettling * time_s);
  pose.root_position += settled(origin.root, origin.root_velocity, time_s, decay);
  for (Role role : roles) {
    const Eigen::Vector3f turn =
        settled(origin.turn[role], origin.turn_velocity[role], time_s, decay);
    pose.rotation[role] = (motion::rotation_by<float>(turn) * pose.rotation[role]).normalized();
  }
  return pose;
}

}  // namespace flinch::runtime
