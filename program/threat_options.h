// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/options.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::program {

/// A threat as options say it. Angles in degrees.
struct ThreatOptions {
  double azimuth = 0;
  std::optional<double> elevation;
  double speed_mps = 20;
  std::string target{"head"};
  double time_to_impact_s = 0.5;
  double radius_m = features::kVolleyballRadius_m;
  double mass_kg = features::kVolleyballMass_kg;
};

std::vector<Option> threat_options(ThreatOptions& threat);

/// The threat that the options describe, of a character whose targets are at `centres`. Throws
/// Error when it would have come out of the ground.
features::ThreatDescription described(const ThreatOptions& options,
                                      const motion::PerTarget<Eigen::Vector3f>& centres);

}  // namespace flinch::program
