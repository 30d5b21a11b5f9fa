// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::database {

/// Posture of the arms during an evasion.
enum class ArmPosture : std::uint8_t {
  hang,     ///< keep their angles to the body
  guard,    ///< bent in front of the chest
  balance,  ///< out to the sides
  cover,    ///< hands on the back of the head
};

/// Displacements from a start pose that take the body, or a part of it, off a threat's line. In the
/// start pose's frame (X is its facing); lengths are fractions of the leg's length, so that they
/// fit any figure. Rotations are angles about x (to the right), y (forward) and z (to the left),
/// radians.
struct Evasion {
  Eigen::Vector3f pelvis_shift = Eigen::Vector3f::Zero();
  Eigen::Vector3f pelvis_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f waist_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f back_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f neck_turn = Eigen::Vector3f::Zero();
  float shrug = 0;  ///< amount of recoil, in [0, 1]
  motion::PerSide<Eigen::Vector3f> foot_shift{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  motion::PerSide<float> foot_pitch{};  ///< of a raised foot; positive: toes down
  ArmPosture arms = ArmPosture::hang;
};

/// Returns a pose whose legs stand at `feet`, with the arms as told. The pelvis is lowered until
/// both legs reach them, and moved until the centre of mass is at least 3 cm inside the soles'
/// hull, where possible.
motion::Pose balanced(const motion::Figure& figure, const motion::PerSide<motion::FootPose>& feet,
                      motion::Pose pose, ArmPosture arms = ArmPosture::hang);

/// Returns the pose of an evasion. The pelvis is lowered until both legs reach their feet, and
/// moved until the centre of mass is at least 3 cm inside the soles' hull, where possible.
motion::Pose evasive_pose(const motion::Figure& figure, const motion::Pose& start,
                          const Evasion& evasion);

/// The rules. `azimuth` is the direction that the threat comes from, radians counter-clockwise from
/// the facing; `amount` in (0, 1] scales the evasion. Sideways means perpendicular to the threat's
/// line: `sense` +1 is counter-clockwise of the threat as seen from above, -1 clockwise.

/// Knees and trunk bend so that the head moves below the threat.
Evasion duck(float azimuth, float amount);
/// The trunk leans and the knees bend so that the head moves beside the threat's line.
Evasion dodge(float azimuth, float sense, float amount);
/// Both feet step so that the whole body moves beside the threat's line. With an amount below 0.5,
/// only one foot steps and the trunk leans.
Evasion sidestep(float azimuth, float sense, float amount);
/// The weight moves to the far leg; the near leg is raised and drawn away; the arms balance.
Evasion lift_leg(float azimuth, float amount);

}  // namespace flinch::database
