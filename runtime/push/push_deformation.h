// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "motion/skeleton.h"

namespace flinch::runtime {

/// How a recorded response is bent to another push than the one that was recorded: theta of Arikan
/// et al. 2005, section 3.2, with the joint that is pushed.
///
/// Joint i moves by an offset with the velocity m_i = m exp(-w d_i^2), where d_i is its distance
/// from the pushed joint when the push comes. The paper adds m_i at once. Recorded pushes last for
/// rise_s, so here the velocity of the offset grows to m_i in that time,
///
///     O'(t) = m_i (3 s^2 - 2 s^3),   s = t / rise_s,
///
/// and then dies away by motion::offset_spring. With rise_s = 0 it is the paper's.
struct PushDeformation {
  motion::Role place = motion::Role::chest;            ///< the pushed joint
  float taper = 1;                                     ///< w, 1/m^2
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();  ///< m, world, m/s
  float rise_s = 0;
};

/// O(t) for an m_i of 1 m/s, m; `time_s` is after the push.
float deformation_offset(float rise_s, float time_s) noexcept;

/// exp(-w d_i^2) of every joint. `frames` are those of the pose that is pushed.
motion::PerRole<float> deformation_shares(const PushDeformation& deformation,
                                          const motion::JointFrames& frames) noexcept;

/// The joints at which a character can be pushed, and those that lead there; parents first.
inline constexpr std::array kTrunkRoles{
    motion::Role::pelvis,         motion::Role::abdomen,        motion::Role::chest,
    motion::Role::neck,           motion::Role::head,           motion::Role::left_clavicle,
    motion::Role::left_upper_arm, motion::Role::right_clavicle, motion::Role::right_upper_arm};

/// Moves the joints of trunk and arms by their `shifts` (world, m) as far as the bones, which keep
/// their lengths, allow: parents first, each with the least turn that points its bone at where the
/// next joint should be. The pelvis turns the trunk as a whole; the chest also turns about its axis
/// with the shoulders. Head and hands keep their orientation in the world. The legs move with the
/// pelvis. `frames` are those of `pose`. Allocates nothing.
void shift_joints(const motion::Skeleton& skeleton, const motion::JointFrames& frames,
                  const motion::PerRole<Eigen::Vector3f>& shifts, motion::Pose& pose) noexcept;

/// The same for kTrunkRoles alone, of which it places all where shift_joints() does. The
/// orientation of the head and of the upper arms stays as it is in their parents.
void shift_trunk(const motion::Skeleton& skeleton, const motion::JointFrames& frames,
                 const motion::PerRole<Eigen::Vector3f>& shifts, motion::Pose& pose) noexcept;

}  // namespace flinch::runtime
