// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "features/geometry.h"

namespace flinch::features {

/// What a character's stance does at the predicted contact, if it goes on until then: which motion
/// a response begins in. In the frame of Geometry.
struct StanceFeatures {
  float velocity_x, velocity_y;                 ///< of the pelvis along the ground, m/s
  float turn_rate;                              ///< counter-clockwise, radians/s
  float weight_left;                            ///< share of the weight on the left foot, 0 to 1
  float left_hand_x, left_hand_y, left_hand_z;  ///< of the wrist, m
  float right_hand_x, right_hand_y, right_hand_z;
};

inline constexpr int kStanceFeatureCount = 10;

/// Component names in the order of the struct.
inline constexpr std::array<std::string_view, kStanceFeatureCount> kStanceFeatureNames{
    "velocity_x",  "velocity_y",  "turn_rate",    "weight_left",  "left_hand_x",
    "left_hand_y", "left_hand_z", "right_hand_x", "right_hand_y", "right_hand_z"};

/// Returns these for a character in this state, `time_s` after perception. Takes a few
/// microseconds.
StanceFeatures stance_features(const IdlingFigure& figure, const CharacterState& state,
                               float time_s);

}  // namespace flinch::features
