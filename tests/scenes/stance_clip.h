// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "database/library/library.h"

namespace flinch::tests {

/// Adds a motion to a library as its last stance, whose clip and kind have the same name.
inline database::ClipLibrary with_stance(database::ClipLibrary library, const std::string& name,
                                         motion::Motion motion) {
  motion::Clip clip;
  clip.name = name;
  clip.purpose = motion::Purpose::stance;
  clip.kind = name;
  clip.source = "made by rule";
  clip.motion = std::move(motion);
  library.clips.push_back(std::move(clip));
  return library;
}

}  // namespace flinch::tests
