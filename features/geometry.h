// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "features/scenario.h"
#include "features/target_centres.h"

namespace flinch::features {

/// A character at the predicted contact, if it keeps on idling until then. World, m.
struct PredictedCharacter {
  Eigen::Vector3f pelvis = Eigen::Vector3f::Zero();
  TargetCentres target_centres{};
};

/// How a threat meets the character: where, from where and how far from each part, at the time to
/// impact. Along the path nothing counts but the time, so it makes no difference whether that is of
/// the aim, as in training, or of the target's centre, as a game predicts it.
///
/// In the character's frame at the contact: origin on the ground below the pelvis as it will be, X
/// along CharacterState::facing, Z up. So turning or moving the whole world changes nothing.
struct Geometry {
  /// Of the threat's centre where its path is nearest to the target's centre, m.
  float contact_x, contact_y, contact_z;
  float approach_x, approach_y, approach_z;  ///< unit vector of its velocity; 0 if it stands still
  float impact_speed_mps;
  /// How far the path passes the target's centre: to the left as the threat flies, and upwards, m.
  float offset_side, offset_up;
  /// The same of each target's centre.
  float miss_head_side, miss_head_up;
  float miss_trunk_side, miss_trunk_up;
  float miss_pelvis_side, miss_pelvis_up;
  float miss_legs_side, miss_legs_up;
};

inline constexpr int kGeometryCount = 17;

/// Names of the components in the order of the struct.
inline constexpr std::array<std::string_view, kGeometryCount> kGeometryNames{
    "contact_x",      "contact_y",        "contact_z",     "approach_x",       "approach_y",
    "approach_z",     "impact_speed_mps", "offset_side",   "offset_up",        "miss_head_side",
    "miss_head_up",   "miss_trunk_side",  "miss_trunk_up", "miss_pelvis_side", "miss_pelvis_up",
    "miss_legs_side", "miss_legs_up"};

/// Of a scenario, with the character as it will be.
Geometry geometry_of(const Scenario& scenario, const PredictedCharacter& character);

/// A character that idles with `idle`. Refers to all three, which must outlive it.
struct IdlingFigure {
  const motion::Skeleton* skeleton = nullptr;
  const motion::BodyModel* model = nullptr;
  const motion::Motion* idle = nullptr;  ///< at least one pose
};

/// The character `time_s` after perception. A few hundred nanoseconds.
PredictedCharacter predict_character(const IdlingFigure& figure, const CharacterState& state,
                                     float time_s);

}  // namespace flinch::features
