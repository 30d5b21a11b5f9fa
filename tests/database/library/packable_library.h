// SPDX-License-Identifier: MIT
#pragma once

#include "database/files/pose_packer.h"
#include "database/library/file_header.h"
#include "motion/mirror.h"
#include "tests/database/library/random_library.h"

namespace flinch::tests {

inline constexpr database::FileFormat kPackedFormat{.magic = database::kLibraryFormat.magic,
                                                    .version = database::kPackedVersion};

/// A random library on the grid whose last clip is the mirror image of its first. The one named
/// block_mirrored is none, only by its name.
inline database::ClipLibrary packable(unsigned seed, int poses) {
  database::ClipLibrary library = random_library(seed, poses);
  library.clips.push_back(motion::mirrored(library.clips[0]));
  library.clips[2].name = "other";
  database::snap(library);
  return library;
}

}  // namespace flinch::tests
