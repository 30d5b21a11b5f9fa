// SPDX-License-Identifier: MIT
#include "program/look_ahead_option.h"

#include "models/selector.h"
#include "motion/error.h"

namespace flinch::program {

Option look_ahead_option(std::optional<int>& candidates) {
  return {"--look-ahead",
          "simulate this many of the selector's best clips and take the one that costs least "
          "(default: take the first)",
          &candidates, Range{1, double{lookahead::kMaxCandidates}}};
}

lookahead::LookAheadWorkspace look_ahead_workspace(const runtime::Library& library,
                                                   const std::string& path) {
  if (!library.selector().costs)
    throw Error(path,
                "the selector does not hold what its clips cost, which --look-ahead needs; run "
                "`flinch train` again");
  lookahead::LookAheadWorkspace workspace;
  if (!workspace.reserve_memory(library, lookahead::make_look_ahead_data(library)))
    throw Error("", "there is not enough memory");
  return workspace;
}

}  // namespace flinch::program
