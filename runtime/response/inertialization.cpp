// SPDX-License-Identifier: MIT
#include "runtime/response/inertialization.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;

// A sole this near to the ground stands on it: games' ground and ours may differ a little.
constexpr float kMaxGameStandingHeight_m = 0.02F;  // m

Eigen::Vector3f rotation_between(const Pose& idle, const Pose& pose, Role role) {
  return motion::rotation_vector(pose.rotation[role] * idle.rotation[role].conjugate());
}

Eigen::Vector3f decayed(const Eigen::Vector3f& x, const Eigen::Vector3f& v, float time_s,
                        float decay) {
  return (x + (v + kDecayRate * x) * time_s) * decay;
}

}  // namespace

// Feet say which way a body stands: a pelvis turns with what the body does. Those in the air count
// only where none stands.
features::CharacterState idle_state_at(const PreparedLibrary& library, const Pose& pose) {
  const motion::Skeleton& skeleton = library.skeleton();
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
  const motion::JointFrames idle =
      motion::forward_kinematics(skeleton, library.idle().poses.front());
  const Eigen::Vector3f centre = motion::centre_of_mass(library.body_model, frames);
  motion::PerSide<float> height{};
  motion::PerSide<float> distance{};
  for (motion::Side side : motion::kSides) {
    height[side] = min_height(library.soles[side], frames, side);
    distance[side] = (motion::foot_pose(frames, side).ankle - centre).head<2>().norm();
  }
  const float standing = std::max(
      kMaxGameStandingHeight_m, std::min(height[motion::Side::left], height[motion::Side::right]));
  Eigen::Vector2f heading = Eigen::Vector2f::Zero();
  motion::Side support = motion::Side::left;
  float nearest = std::numeric_limits<float>::infinity();
  for (motion::Side side : motion::kSides) {
    if (height[side] > standing) continue;
    const Eigen::Quaternionf turn = motion::foot_pose(frames, side).orientation *
                                    motion::foot_pose(idle, side).orientation.conjugate();
    heading += (turn * Eigen::Vector3f::UnitX()).head<2>();
    if (distance[side] < nearest) {
      nearest = distance[side];
      support = side;
    }
  }
  features::CharacterState state;
  state.facing = std::atan2(heading.y(), heading.x());
  const Eigen::Quaternionf facing = motion::rotation_about(Eigen::Vector3f::UnitZ(), state.facing);
  state.position =
      (motion::foot_pose(frames, support).ankle - facing * motion::foot_pose(idle, support).ankle)
          .head<2>();
  return state;
}

Inertialization make_inertialization(const PreparedLibrary& library,
                                     const features::CharacterState& state, const Pose& before,
                                     const Pose& now, float dt_s) noexcept {
  constexpr float kTurn = std::numbers::pi_v<float>;
  Inertialization inertialization;
  inertialization.is_zero = false;
  const bool moves = dt_s > 0;
  const Pose idle = features::idle_pose(library.idle(), state, 0);
  const Pose idle_before = features::idle_pose(library.idle(), state, moves ? -dt_s : 0);
  inertialization.root = now.root_position - idle.root_position;
  if (moves) {
    inertialization.root_velocity =
        (inertialization.root - (before.root_position - idle_before.root_position)) / dt_s;
  }
  for (Role role : motion::kRoles) {
    inertialization.rotation[role] = rotation_between(idle, now, role);
    const Eigen::Vector3f change =
        inertialization.rotation[role] - rotation_between(idle_before, before, role);
    // Vectors of almost half a turn may change sides between two poses: that is no velocity.
    inertialization.rotation_velocity[role] =
        moves && change.norm() < kTurn ? Eigen::Vector3f(change / dt_s) : Eigen::Vector3f::Zero();
  }
  const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), now);
  for (motion::Side side : motion::kSides) {
    inertialization.stands[side] =
        min_height(library.soles[side], frames, side) < kMaxGameStandingHeight_m;
    inertialization.foot[side] = motion::foot_pose(frames, side);
  }
  return inertialization;
}

Pose inertialized_pose(const PreparedLibrary& library, const features::CharacterState& state,
                       const Inertialization& inertialization, float time_s,
                       std::span<const Role> roles) noexcept {
  Pose pose = features::idle_pose(library.idle(), state, time_s, roles);
  if (inertialization.is_zero) return pose;
  const float decay = std::exp(-kDecayRate * time_s);
  pose.root_position += decayed(inertialization.root, inertialization.root_velocity, time_s, decay);
  for (Role role : roles) {
    const Eigen::Vector3f turn = decayed(inertialization.rotation[role],
                                         inertialization.rotation_velocity[role], time_s, decay);
    pose.rotation[role] =
        (motion::rotation_from_vector<float>(turn) * pose.rotation[role]).normalized();
  }
  return pose;
}

}  // namespace flinch::runtime
