// SPDX-License-Identifier: MIT
#pragma once

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

/// A scenario with the impulses and work of every clip that was tried on it: the allowed clips and
/// the idle clip, in ascending order.
struct Observation {
  std::uint64_t number = 0;  ///< of the scenario
  features::Scenario scenario;
  features::FeatureVector features{};  ///< see StoreHeader::layout
  std::vector<Trial> trials;
};

/// Returns the direction from which the threat comes at perception, radians counter-clockwise from
/// the character's facing.
float azimuth_of(const features::Scenario& scenario);

/// Returns the index of a clip's trial. Throws Error if the clip was not tried.
std::size_t trial_of(const Observation& observation, int clip);

}  // namespace flinch::train
