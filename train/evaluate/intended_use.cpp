// SPDX-License-Identifier: MIT
#include "train/evaluate/intended_use.h"

#include <cmath>

#include "motion/rotation.h"

namespace flinch::train {
namespace {

const float kFar = motion::radians(135.0F);
constexpr float kDirectionRounding = 1e-4F;  // directions are floats

}  // namespace

IntendedUse intended_use(const StoreHeader& header, std::span<const Observation> observations,
                         std::span<const int> chosen) {
  IntendedUse use;
  const double share = 1 / static_cast<double>(observations.size());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& made_for = header.clips[static_cast<std::size_t>(chosen[i])].annotation;
    if (chosen[i] == header.idle || !made_for) continue;
    const features::Scenario& scenario = observations[i].scenario;
    const float apart = motion::wrapped_to_pi(made_for->direction - azimuth_of(scenario));
    const bool is_other = made_for->target != scenario.target;
    const bool is_far = std::abs(apart) >= kFar - kDirectionRounding;
    if (is_other) use.other_target += share;
    if (is_far) use.far_direction += share;
    if (is_other && is_far) use.luck += share;
  }
  return use;
}

}  // namespace flinch::train
