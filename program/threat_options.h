// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/selector.h"
#include "program/options.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::program {

/// A threat as given by options. Angles in degrees.
struct ThreatOptions {
  std::optional<std::string> kind;  ///< of the selector's; without it, the first
  double azimuth = 0;
  std::optional<double> elevation;
  std::optional<double> speed_mps;
  std::string target{"head"};
  double time_to_impact_s = 0.5;
  std::optional<double> radius_m;
  std::optional<double> mass_kg;
};

/// The names of all targets, for options.
std::vector<std::string> target_names();

std::vector<Option> threat_options(ThreatOptions& threat);

/// Returns the threat that the options describe, to the selector's idling character. What they
/// leave out is that of a volleyball at 20 m/s, or the nearest that the kind has in its ranges.
/// Throws Error for a kind that the selector does not know, and if the threat would have started
/// below the ground.
features::ThreatDescription described(const ThreatOptions& options,
                                      const models::Selector& selector);

}  // namespace flinch::program
