// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::database {

/// What the arms do while the body goes out of the way.
enum class ArmPosture : std::uint8_t {
  hang,     ///< stay with the body
  guard,    ///< bent before the chest
  balance,  ///< out to the sides
  cover,    ///< hands on the back of the head
};

/// A pose that takes the body, or a part of it, off a threat's line: displacements from a start
/// pose, in its frame (X its facing), lengths as fractions of the leg's length so that they fit any
/// figure. Rotations are angles about y (bowing) and x (to the right), and z (to the left),
/// radians.
struct Evasion {
  Eigen::Vector3f pelvis_shift = Eigen::Vector3f::Zero();
  Eigen::Vector3f pelvis_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f waist_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f back_turn = Eigen::Vector3f::Zero();
  Eigen::Vector3f neck_turn = Eigen::Vector3f::Zero();
  float shrug = 0;  ///< amount of recoil, in [0, 1]
  motion::PerSide<Eigen::Vector3f> foot_shift{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  motion::PerSide<float> foot_pitch{};  ///< toes down, of a raised foot
  ArmPosture arms = ArmPosture::hang;
};

/// The pose of an evasion. The pelvis comes down until both legs reach their feet, and moves until
/// the centre of mass is above the soles by at least 3 cm within, where that can be.
motion::Pose evasive_pose(const motion::Figure& figure, const motion::Pose& start,
                          const Evasion& evasion);

/// The rules. `azimuth` says where the threat comes from, radians counter-clockwise from the
/// facing; `amount` in (0, 1] how far to go. Sideways means square to the threat's line: `sense`
/// +1 goes counter-clockwise of the threat as seen from above, -1 clockwise.

/// Knees bend and the trunk bows so that the head goes below the threat.
Evasion duck(float azimuth, float amount);
/// The trunk leans and the knees give so that the head goes beside the threat's line.
Evasion dodge(float azimuth, float sense, float amount);
/// Both feet step so that the whole body is beside the threat's line; a small one (amount below one
/// half) steps with one foot and leans.
Evasion sidestep(float azimuth, float sense, float amount);
/// The weight goes to the far leg, and the near leg is raised and drawn away; arms for balance.
Evasion lift_leg(float azimuth, float amount);

}  // namespace flinch::database
