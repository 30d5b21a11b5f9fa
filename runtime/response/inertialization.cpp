// SPDX-License-Identifier: MIT
#include "runtime/response/inertialization.h"

#include <algorithm>
#include <array>
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

Eigen::Vector3f decayed(const Eigen::Vector3f& x, const Eigen::Vector3f& v, float rate,
                        float time_s, float decay) {
  return (x + (v + rate * x) * time_s) * decay;
}

Eigen::Quaternionf settled(const Inertialization& inertialization, Role role, float time_s,
                           float decay, const Eigen::Quaternionf& idle) {
  const float stiffening = inertialization.stiffening[role];
  if (stiffening > 0) decay *= std::exp(-stiffening * time_s);
  const Eigen::Vector3f turn =
      decayed(inertialization.rotation[role], inertialization.rotation_velocity[role],
              kDecayRate + stiffening, time_s, decay);
  return motion::rotation_from_vector<float>(turn) * idle;
}

/// Calls `visit` for each joint that turns `limits.to` against `limits.from`, the last one first.
template <class Visit>
void for_each_joint(const motion::JointLimits& limits, Visit visit) {
  for (Role role = limits.to; role != limits.from; role = *motion::parent_of(role)) visit(role);
}

template <class RotationOf>
Eigen::Vector3f angles_of(const motion::JointLimits& limits, RotationOf rotation_of) {
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
  for_each_joint(limits, [&](Role role) { rotation = rotation_of(role) * rotation; });
  return motion::joint_angles(limits, rotation);
}

// Stiffens joints that would swing past their limits. A difference leaves the way from x_0 to 0 by
// at most |v_0| / (e k), some time after 1 / k at the latest; only there limits need to be looked
// at. A joint may be as far beyond as either motion is.
void stiffen_at_limits(const PreparedLibrary& library, const Pose& idle, const Pose& now,
                       Inertialization& inertialization) {
  constexpr float kTolerance = 0.02F;  // radians
  constexpr float kGrowth = 1.5F;      // of k in one round
  constexpr int kMaxRounds = 6;        // up to 114 1/s: more would look like a jolt
  constexpr std::array kShares{0.5F, 1.0F, 1.5F, 2.0F};  // of 1 / k
  for (const motion::JointLimits& limits : library.joint_limits) {
    float speed = 0;
    for_each_joint(limits,
                   [&](Role role) { speed += inertialization.rotation_velocity[role].norm(); });
    if (speed < kTolerance * std::numbers::e_v<float> * kDecayRate) continue;
    const Eigen::Vector3f idle_angles =
        angles_of(limits, [&](Role role) { return idle.rotation[role]; });
    const Eigen::Vector3f angles_now =
        angles_of(limits, [&](Role role) { return now.rotation[role]; });
    const Eigen::Vector3f min = limits.min.cwiseMin(idle_angles).cwiseMin(angles_now);
    const Eigen::Vector3f max = limits.max.cwiseMax(idle_angles).cwiseMax(angles_now);
    const auto is_within = [&](float share) {
      const Eigen::Vector3f angles = angles_of(limits, [&](Role role) {
        const float time_s = share / (kDecayRate + inertialization.stiffening[role]);
        return settled(inertialization, role, time_s, std::exp(-kDecayRate * time_s),
                       idle.rotation[role]);
      });
      return (angles.array() <= max.array() + kTolerance).all() &&
             (angles.array() >= min.array() - kTolerance).all();
    };
    const motion::PerRole<float> unchanged = inertialization.stiffening;
    int round = 0;
    for (; round < kMaxRounds && !std::ranges::all_of(kShares, is_within); ++round) {
      for_each_joint(limits, [&](Role role) {
        float& stiffening = inertialization.stiffening[role];
        stiffening = kGrowth * (kDecayRate + stiffening) - kDecayRate;
      });
    }
    // Angles of more than half a turn change sides, as those of a raised arm may.
    if (round == kMaxRounds) inertialization.stiffening = unchanged;
  }
}

}  // namespace

// Feet say which way a body stands: a pelvis turns with what the body does. Those in the air count
// only where none stands.
features::CharacterState rest_state_at(const PreparedLibrary& library, const Pose& pose, int stance,
                                       std::optional<float> facing_known) {
  features::CharacterState state;
  state.stance = stance;
  const motion::Skeleton& skeleton = library.skeleton();
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
  const motion::JointFrames idle =
      motion::forward_kinematics(skeleton, library.rest_of(state).loop.motion().poses.front());
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
  state.facing = facing_known.value_or(std::atan2(heading.y(), heading.x()));
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
  const motion::Loop& rest = library.rest_of(state).loop;
  const Pose idle = features::idle_pose(rest, state, 0);
  const Pose idle_before = features::idle_pose(rest, state, moves ? -dt_s : 0);
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
  stiffen_at_limits(library, idle, now, inertialization);
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
  if (inertialization.is_zero)
    return features::idle_pose(library.stance_of(state).loop, state, time_s, roles);
  Pose pose = features::idle_pose(library.rest_of(state).loop, state, time_s, roles);
  const float decay = std::exp(-kDecayRate * time_s);
  pose.root_position +=
      decayed(inertialization.root, inertialization.root_velocity, kDecayRate, time_s, decay);
  for (Role role : roles) {
    const Eigen::Quaternionf idle = pose.rotation[role];
    pose.rotation[role] = settled(inertialization, role, time_s, decay, idle).normalized();
    const motion::JointLimits* limits = library.wrist_limits[role];
    if (limits != nullptr && !is_clearly_within(*limits, pose.rotation[role])) {
      const Eigen::Quaternionf at_first =
          motion::rotation_from_vector<float>(inertialization.rotation[role]) * idle;
      pose.rotation[role] = clamp_to_limits(*limits, pose.rotation[role], at_first);
    }
  }
  return pose;
}

}  // namespace flinch::runtime
