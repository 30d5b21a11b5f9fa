// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "features/scenario.h"
#include "motion/loop.h"

namespace flinch::features {

/// The character at the predicted contact, if it goes on in its stance until then. World, m.
struct PredictedCharacter {
  Eigen::Vector3f pelvis = Eigen::Vector3f::Zero();
  motion::PerTarget<Eigen::Vector3f> target_centres{};
};

/// Where a threat meets the character, from which direction, and how far it passes each body part,
/// at the time to impact. The components use only the straight path through the threat's position
/// at that time, so they are the same whether the time is that of the aim point, as in training, or
/// of the target's centre, as predicted in a game.
///
/// In the character's frame at the contact: origin on the ground below the predicted pelvis, X
/// along CharacterState::facing, Z up. They do not change when the whole world is rotated or moved.
struct Geometry {
  /// Position of the threat's centre, or of the striking point of a rod (striking_point), where its
  /// path is nearest to the target's centre, m.
  float contact_x, contact_y, contact_z;
  float approach_x, approach_y, approach_z;  ///< unit vector of its velocity; 0 if it stands still
  float impact_speed_mps;
  /// Offset of the path from the target's centre: to the left as seen along the flight, and
  /// upwards, m.
  float offset_side, offset_up;
  /// The same offset from the centre of each target.
  float miss_head_side, miss_head_up;
  float miss_trunk_side, miss_trunk_up;
  float miss_pelvis_side, miss_pelvis_up;
  float miss_legs_side, miss_legs_up;
};

inline constexpr int kGeometryCount = 17;

/// Component names in the order of the struct.
inline constexpr std::array<std::string_view, kGeometryCount> kGeometryNames{
    "contact_x",      "contact_y",        "contact_z",     "approach_x",       "approach_y",
    "approach_z",     "impact_speed_mps", "offset_side",   "offset_up",        "miss_head_side",
    "miss_head_up",   "miss_trunk_side",  "miss_trunk_up", "miss_pelvis_side", "miss_pelvis_up",
    "miss_legs_side", "miss_legs_up"};

/// Returns the geometry of a scenario, with the character as predicted at the contact.
Geometry geometry_of(const Scenario& scenario, const PredictedCharacter& character);

/// A character that goes on in a stance. Refers to all three objects, which must outlive it.
struct IdlingFigure {
  const motion::Skeleton* skeleton = nullptr;
  const motion::BodyModel* model = nullptr;
  motion::Loop stance;
};

/// Predicts the character `time_s` after perception. Takes a few hundred nanoseconds.
PredictedCharacter predict_character(const IdlingFigure& figure, const CharacterState& state,
                                     float time_s);

}  // namespace flinch::features
