// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/annotate/draft.h"

namespace flinch::database {

/// What a drafted manifest says beside the draft itself.
struct DraftPaths {
  std::string take;   ///< the BVH file, as seen from the manifest's folder
  std::string sheet;  ///< the contact sheet, likewise
  std::string rest;   ///< the file of options.rest, likewise; empty without one
};

/// Returns a draft as a manifest in TOML (docs/importing.md) that import accepts as it is. A
/// comment beside each guess gives its confidence and reason. `options` are those that the take was
/// read with; they go into its [source] table.
std::string draft_toml(const Draft& draft, const DraftPaths& paths, const SourceOptions& options);

}  // namespace flinch::database
