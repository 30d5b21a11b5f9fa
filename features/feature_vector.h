// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/scenario.h"

namespace flinch::features {

/// The paper's features (Zordan et al. 2007, section 5), in the character's frame at perception:
/// origin on the ground below the pelvis, X along CharacterState::facing, Z up. So turning or
/// moving the whole world changes nothing.
struct Features {
  float position_x, position_y, position_z;  ///< of the threat, m
  float heading_x, heading_y, heading_z;     ///< unit vector of its velocity; 0 if it stands still
  float speed_mps;
  float time_to_impact_s;
  float target_head, target_trunk, target_pelvis, target_legs;  ///< one of them 1, the others 0
  /// Look-ahead: where the pelvis will be, m, and which way it will point at the predicted contact,
  /// if the character keeps on idling.
  float ahead_x, ahead_y, ahead_facing_sin, ahead_facing_cos;
};

inline constexpr int kFeatureCount = 16;

/// Names of the components, in the vector's order: the layout that travels with a selector.
inline constexpr std::array<std::string_view, kFeatureCount> kFeatureNames{
    "position_x",  "position_y",   "position_z",       "heading_x",
    "heading_y",   "heading_z",    "speed_mps",        "time_to_impact_s",
    "target_head", "target_trunk", "target_pelvis",    "target_legs",
    "ahead_x",     "ahead_y",      "ahead_facing_sin", "ahead_facing_cos"};

/// The features of a scenario of a character that idles with `idle`.
Features features_of(const Scenario& scenario, const motion::Motion& idle);

/// The most components that a selector's features have.
inline constexpr int kMaxFeatures = kFeatureCount + 17;

/// Components in the order of some layout (features/feature_layout.h), 0 beyond its size.
using FeatureVector = std::array<float, kMaxFeatures>;

/// In the order of kFeatureNames.
FeatureVector to_vector(const Features& features);

/// Brings each component into [-1, 1] over the observations that it was made from, as libsvm's
/// svm-scale does; a component that never varies becomes 0.
struct Scaling {
  std::vector<double> min;  ///< one a component
  std::vector<double> max;

  /// scaled_i = -1 + 2 (x_i - min_i) / (max_i - min_i), in double and rounded to a float, so
  /// that what a model keeps is what other tools are given; of the first scaled.size() components,
  /// as many as `min` and `max` have. Values outside of the observed range go beyond [-1, 1].
  void apply(std::span<const float> raw, std::span<double> scaled) const;
};

/// The scaling of these rows' first names.size() components. Throws Error for no rows or a value
/// that is not finite, which it names.
Scaling make_scaling(std::span<const FeatureVector> rows, std::span<const std::string> names);

}  // namespace flinch::features
