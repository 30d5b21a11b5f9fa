// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "train/scenario/scenario_sampling.h"

namespace flinch::train {

/// A shipped distribution of threats: its name, and the text of its file.
struct ThreatFile {
  std::string_view name;
  std::string_view text;
};

/// Returns the shipped files, "default", "balls" and "kinds"; the first is that of the distribution
/// that ScenarioDistribution has by default.
std::span<const ThreatFile> threat_files();

/// Returns the distribution in the text of a TOML file (docs/threats.md): a list `kind` of tables,
/// in each a name, and whatever differs from the default kind. `path` is for messages. Throws Error
/// "PATH:LINE: …" for an unknown key, a kind without a name or with that of another, no weight at
/// all, a range the wrong way round, a number out of its bounds, times to impact that are not on
/// one grid, more than 16 sectors of a kind, and more than features::kMaxThreatKinds kinds.
ScenarioDistribution parse_threats(std::string_view text, const std::string& path);

/// Returns the shipped distribution with that name or, if it ends in ".toml", the one in that file.
/// Throws Error as parse_threats does, and for a name that is not shipped.
ScenarioDistribution find_threats(const std::string& name_or_file);

}  // namespace flinch::train
