// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "features/feature_layout.h"
#include "features/scenario.h"
#include "motion/body.h"

namespace flinch::train {

/// Result of one clip in one scenario.
struct Trial {
  int clip = 0;                    ///< index in the library
  float work_j = 0;                ///< of the whole response, all bodies
  motion::PerBody<float> impulse;  ///< N·s, unweighted
};

/// Where a body was hit in a trial: a part of its impulse.
struct HitPlace {
  int clip = 0;
  motion::Body body{};
  float impulse_ns = 0;
  std::array<std::int16_t, 3> point_mm{};  ///< in the frame of the body's joint
};

/// The most that a trial has.
inline constexpr std::size_t kMaxPlacesPerTrial = 256;

/// Returns the point, m.
Eigen::Vector3f point_of(const HitPlace& place);

/// A scenario with the impulses and work of every clip that was tried on it: the allowed clips and
/// the idle clip, in ascending order.
struct Observation {
  std::uint64_t number = 0;  ///< of the scenario
  features::Scenario scenario;
  features::FeatureVector features{};  ///< see StoreHeader::layout
  std::vector<Trial> trials;
  /// Where the bodies were hit, in ascending order of clips; empty unless SimulationPlan::options
  /// keeps places.
  std::vector<HitPlace> places;
};

/// Returns the direction from which the threat comes at perception, radians counter-clockwise from
/// the character's facing.
float azimuth_of(const features::Scenario& scenario);

/// Returns the index of a clip's trial. Throws Error if the clip was not tried.
std::size_t trial_of(const Observation& observation, int clip);

}  // namespace flinch::train
