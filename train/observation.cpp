// SPDX-License-Identifier: MIT
#include "train/observation.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"

namespace flinch::train {

namespace {

std::size_t component(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(features::kFeatureNames, name) -
                                  features::kFeatureNames.begin());
}

}  // namespace

float azimuth_of(const features::FeatureVector& features) {
  static const std::size_t kHeadingX = component("heading_x");
  static const std::size_t kHeadingY = component("heading_y");
  return std::atan2(-features[kHeadingY], -features[kHeadingX]);
}

std::size_t trial_of(const Observation& observation, int clip) {
  const auto found = std::ranges::find(observation.trials, clip, &Trial::clip);
  if (found == observation.trials.end())
    throw Error("", "clip " + std::to_string(clip) + " was never tried on scenario " +
                        std::to_string(observation.number) +
                        "; the store and the mask disagree, simulate it again");
  return static_cast<std::size_t>(found - observation.trials.begin());
}

}  // namespace flinch::train
