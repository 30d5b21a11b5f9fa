// SPDX-License-Identifier: MIT
#include "train/objective/observation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/error.h"

namespace flinch::train {

float azimuth_of(const features::Scenario& scenario) {
  const Eigen::Vector3f from = -scenario.threat.velocity;
  return std::remainder(std::atan2(from.y(), from.x()) - scenario.state.facing,
                        2 * std::numbers::pi_v<float>);
}

std::size_t trial_of(const Observation& observation, int clip) {
  const auto found = std::ranges::find(observation.trials, clip, &Trial::clip);
  if (found == observation.trials.end())
    throw Error("", "clip " + std::to_string(clip) + " was never tried on scenario " +
                        std::to_string(observation.number) +
                        "; the store does not fit the mask, simulate it again");
  return static_cast<std::size_t>(found - observation.trials.begin());
}

}  // namespace flinch::train
