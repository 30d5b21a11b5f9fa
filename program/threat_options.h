// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/options.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::program {

/// A threat as given by options. Angles in degrees.
struct ThreatOptions {
  double azimuth = 0;
  std::optional<double> elevation;
  double speed_mps = 20;
  std::string target{"head"};
  double time_to_impact_s = 0.5;
  double radius_m = features::kVolleyballRadius_m;
  double mass_kg = features::kVolleyballMass_kg;
};

/// The names of all targets, for options.
std::vector<std::string> target_names();

std::vector<Option> threat_options(ThreatOptions& threat);

/// Returns the threat that the options describe, to a character whose targets are at `centres`.
/// Throws Error if it would have started below the ground.
features::ThreatDescription described(const ThreatOptions& options,
                                      const motion::PerTarget<Eigen::Vector3f>& centres);

}  // namespace flinch::program
