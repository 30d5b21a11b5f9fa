// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

#include "motion/role.h"

namespace flinch::database {

/// Positions of all joints in one frame, m.
using JointPositions = motion::PerRole<Eigen::Vector3f>;

/// The joints that stand for the whole body: pelvis, chest, head, elbows, wrists, knees, ankles.
inline constexpr std::array kTrackedJoints{
    motion::Role::pelvis,       motion::Role::chest,     motion::Role::head,
    motion::Role::left_forearm, motion::Role::left_hand, motion::Role::right_forearm,
    motion::Role::right_hand,   motion::Role::left_shin, motion::Role::left_foot,
    motion::Role::right_shin,   motion::Role::right_foot};

/// Returns the root mean square of the distance between two poses over kTrackedJoints, m.
float pose_distance(const JointPositions& one, const JointPositions& other);

/// The body's speed, as pose_distance per time, that no recording reaches, m/s. In the fastest
/// recorded movements (a roll, a long jump) it is 5; a T-pose in the first frame leaves at 9.
inline constexpr float kMaxBodySpeed_mps = 7.2F;

/// Returns whether both arms are stretched sideways at shoulder height: the pose of a calibration,
/// which no one rests in. Z is up.
bool is_t_pose(const JointPositions& joints);

}  // namespace flinch::database
