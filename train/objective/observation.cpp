// SPDX-License-Identifier: MIT
#include "train/objective/observation.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::train {

Eigen::Vector3f point_of(const HitPlace& place) {
  return Eigen::Vector3f(place.point_mm[0], place.point_mm[1], place.point_mm[2]) / 1000;
}

float azimuth_of(const features::Scenario& scenario) {
  const Eigen::Vector3f from = -scenario.threat.velocity;
  return motion::wrapped_to_pi(motion::yaw_of(from) - scenario.state.facing);
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
