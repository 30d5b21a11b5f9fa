// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "lookahead/look_ahead.h"
#include "program/options.h"

namespace flinch::program {

/// The option --look-ahead, for commands that answer a threat.
Option look_ahead_option(std::optional<int>& candidates);

/// Returns memory to look ahead with the selector of a file. Throws Error if the file does not hold
/// what its clips cost.
lookahead::LookAheadWorkspace look_ahead_workspace(const runtime::Library& library,
                                                   const std::string& path);

}  // namespace flinch::program
