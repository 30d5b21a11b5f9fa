// SPDX-License-Identifier: MIT
#include "runtime/push/push_deformation.h"

#include <array>
#include <cmath>

#include "motion/offset_spring.h"
#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

using motion::JointFrames;
using motion::Role;

/// A joint that turns, and the joint that it points at.
struct Bone {
  Role joint;
  Role end;
};
// Parents first.
constexpr std::array kTrunkBones{Bone{Role::pelvis, Role::chest},
                                 Bone{Role::abdomen, Role::chest},
                                 Bone{Role::chest, Role::neck},
                                 Bone{Role::neck, Role::head},
                                 Bone{Role::left_clavicle, Role::left_upper_arm},
                                 Bone{Role::right_clavicle, Role::right_upper_arm}};
constexpr std::array kArmBones{
    Bone{Role::left_upper_arm, Role::left_forearm}, Bone{Role::left_forearm, Role::left_hand},
    Bone{Role::right_upper_arm, Role::right_forearm}, Bone{Role::right_forearm, Role::right_hand}};
constexpr std::array kKept{Role::head, Role::left_hand, Role::right_hand};

/// The turn about `axis` (unit) that brings the direction `from` nearest to `to`.
Eigen::Quaternionf twist_between(const Eigen::Vector3f& axis, const Eigen::Vector3f& from,
                                 const Eigen::Vector3f& to) {
  const Eigen::Vector3f a = from - axis.dot(from) * axis;
  const Eigen::Vector3f b = to - axis.dot(to) * axis;
  return motion::rotation_about(axis, std::atan2(axis.dot(a.cross(b)), a.dot(b)));
}

/// A pose whose joints are being shifted, and where they have come.
struct Shifting {
  const motion::Skeleton& skeleton;
  const JointFrames& frames;  ///< of the pose before
  const motion::PerRole<Eigen::Vector3f>& shifts;
  JointFrames moved;  ///< of the pelvis and of joints that have turned; others are not set
  motion::Pose& pose;

  Shifting(const motion::Skeleton& of, const JointFrames& from,
           const motion::PerRole<Eigen::Vector3f>& by, motion::Pose& to)
      : skeleton(of), frames(from), shifts(by), pose(to) {
    moved.position[Role::pelvis] = wanted(Role::pelvis);
    pose.root_position = moved.position[Role::pelvis];
  }
  Eigen::Vector3f wanted(Role role) const { return frames.position[role] + shifts[role]; }
  void turn(const Bone& bone);
};

void Shifting::turn(const Bone& bone) {
  const auto [joint, end] = bone;
  const Role parent = motion::kParents[joint];
  if (joint != Role::pelvis) {
    moved.position[joint] =
        moved.position[parent] + motion::rotated(skeleton.offset[joint], moved.orientation[parent]);
  }
  const Eigen::Vector3f direction = wanted(end) - moved.position[joint];
  Eigen::Quaternionf turn =
      motion::rotation_between<float>(frames.position[end] - frames.position[joint], direction);
  if (joint == Role::chest) {
    const auto across = [](const Eigen::Vector3f& left, const Eigen::Vector3f& right) {
      return Eigen::Vector3f(left - right);
    };
    const Eigen::Vector3f shoulders = turn * across(frames.position[Role::left_upper_arm],
                                                    frames.position[Role::right_upper_arm]);
    turn = twist_between(direction.normalized(), shoulders,
                         across(wanted(Role::left_upper_arm), wanted(Role::right_upper_arm))) *
           turn;
  }
  moved.orientation[joint] = (turn * frames.orientation[joint]).normalized();
  pose.rotation[joint] = joint == Role::pelvis
                             ? moved.orientation[joint]
                             : moved.orientation[parent].conjugate() * moved.orientation[joint];
}

}  // namespace

// The integral of 3 s^2 - 2 s^3 is s^3 - s^4 / 2, which ends at 1/2.
float deformation_offset(float rise_s, float time_s) noexcept {
  if (time_s <= 0) return 0;
  if (time_s < rise_s) {
    const float s = time_s / rise_s;
    return rise_s * s * s * s * (1 - s / 2);
  }
  const motion::OffsetSpring spring = motion::offset_spring(time_s - rise_s);
  return spring.position * rise_s / 2 + spring.velocity;
}

motion::PerRole<float> deformation_shares(const PushDeformation& deformation,
                                          const JointFrames& frames) noexcept {
  motion::PerRole<float> shares;
  for (const Role role : motion::kRoles) {
    const float squared =
        (frames.position[role] - frames.position[deformation.place]).squaredNorm();
    shares[role] = std::exp(-deformation.taper * squared);
  }
  return shares;
}

void shift_joints(const motion::Skeleton& skeleton, const JointFrames& frames,
                  const motion::PerRole<Eigen::Vector3f>& shifts, motion::Pose& pose) noexcept {
  Shifting shifting(skeleton, frames, shifts, pose);
  for (const Bone& bone : kTrunkBones) shifting.turn(bone);
  for (const Bone& bone : kArmBones) shifting.turn(bone);
  for (const Role role : kKept) {
    pose.rotation[role] =
        shifting.moved.orientation[motion::kParents[role]].conjugate() * frames.orientation[role];
  }
}

void shift_trunk(const motion::Skeleton& skeleton, const JointFrames& frames,
                 const motion::PerRole<Eigen::Vector3f>& shifts, motion::Pose& pose) noexcept {
  Shifting shifting(skeleton, frames, shifts, pose);
  for (const Bone& bone : kTrunkBones) shifting.turn(bone);
}

}  // namespace flinch::runtime
