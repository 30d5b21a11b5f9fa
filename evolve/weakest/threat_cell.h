// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "features/scenario.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::evolve {

/// Threats that are alike: aimed at one target, from one of eight directions, with a time to impact
/// of one of train::kTimeBins.
struct ThreatCell {
  motion::Target target{};
  int direction = 0;  ///< eighths of a turn, counter-clockwise from the facing: -3 to 4
  int time = 0;       ///< index in train::kTimeBins

  double azimuth() const;  ///< where its threats come from, radians
  auto operator<=>(const ThreatCell&) const = default;
};

/// The cell of a threat to a character that faces +X. Its direction is that of the horizontal
/// velocity, which gravity does not change.
ThreatCell cell_of(const features::Scenario& scenario);
/// The mirror image of a cell, in which the mirror images of its threats are.
ThreatCell mirrored(const ThreatCell& cell);

/// The threats of a distribution that are in a cell, with the same shares among themselves; nothing
/// if there are none. Kinds keep their numbers: those without a threat here have the weight 0.
std::optional<train::ScenarioDistribution> threats_in(
    const train::ScenarioDistribution& distribution, const ThreatCell& cell);

}  // namespace flinch::evolve
