// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/known_kind.h"
#include "features/scenario.h"
#include "motion/loop.h"

namespace flinch::features {

/// The paper's features (Zordan et al. 2007, section 5), in the character's frame at perception:
/// origin on the ground below the pelvis, X along CharacterState::facing, Z up. They do not change
/// when the whole world is rotated or moved.
struct Features {
  float position_x, position_y, position_z;  ///< of the threat's position, m
  float heading_x, heading_y, heading_z;     ///< unit vector of its velocity; 0 if it stands still
  float speed_mps;
  float time_to_impact_s;
  float target_head, target_trunk, target_pelvis, target_legs;  ///< one of them 1, the others 0
  /// Look-ahead: the pelvis' position, m, and facing at the predicted contact, if the character
  /// stays idle.
  float ahead_x, ahead_y, ahead_facing_sin, ahead_facing_cos;
};

inline constexpr int kFeatureCount = 16;

/// Component names in the vector's order. They are stored with a selector as its layout.
inline constexpr std::array<std::string_view, kFeatureCount> kFeatureNames{
    "position_x",  "position_y",   "position_z",       "heading_x",
    "heading_y",   "heading_z",    "speed_mps",        "time_to_impact_s",
    "target_head", "target_trunk", "target_pelvis",    "target_legs",
    "ahead_x",     "ahead_y",      "ahead_facing_sin", "ahead_facing_cos"};

/// Returns the features of a scenario, for a character in this stance, which is that of its state.
Features features_of(const Scenario& scenario, const motion::Loop& stance);

/// Largest number of features that a selector may use: these, those of Geometry, radius, mass and
/// impulse, four of rods, one for each kind of threat, and those of stances.
inline constexpr int kMaxFeatures =
    kFeatureCount + 17 + 3 + 4 + static_cast<int>(kMaxThreatKinds) + 10;

/// Components in the order of a layout (features/feature_layout.h); 0 beyond its size.
using FeatureVector = std::array<float, kMaxFeatures>;

/// Returns the features in the order of kFeatureNames.
FeatureVector to_vector(const Features& features);

/// Maps each component linearly to [-1, 1] over the observations that it was made from, as libsvm's
/// svm-scale does. A constant component becomes 0.
struct Scaling {
  std::vector<double> min;  ///< one per component
  std::vector<double> max;

  /// scaled_i = -1 + 2 (x_i - min_i) / (max_i - min_i), computed in double and rounded to float, so
  /// that a model stores the same numbers that other tools are given. Scales the first
  /// scaled.size() components, as many as `min` and `max` have. Values outside the observed range
  /// exceed [-1, 1].
  void apply(std::span<const float> raw, std::span<double> scaled) const;
};

/// Makes the scaling from the first names.size() components of these rows. Throws Error for no
/// rows, or for a value that is not finite, with its name.
Scaling make_scaling(std::span<const FeatureVector> rows, std::span<const std::string> names);

}  // namespace flinch::features
