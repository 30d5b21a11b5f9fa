// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "database/library/library.h"
#include "motion/body.h"

namespace flinch::database {

/// Makes the default library: an idle clip and protective clips made by rule (docs/authoring.md)
/// for any character, each with its mirror image. It has blocks, ducks, dodges, sidesteps and leg
/// lifts, mild and exaggerated, for head, trunk, pelvis and legs and for eight directions, each
/// fully annotated. With startle, blocks begin with a flinch. Its poses are on the grid of files
/// (database/files/pose_packer.h). The same character gives the same bits. Throws Error where the
/// figure cannot stand or move as the rules require.
ClipLibrary authored_library(const motion::Physique& character, bool with_startle = false,
                             float rate_hz = 60);

/// The same before its poses are moved to the grid, to measure by how much that moves joints.
ClipLibrary authored_library_off_grid(const motion::Physique& character, bool with_startle = false,
                                      float rate_hz = 60);

/// The provenance of the library of a character: find_character's argument, or none for the default
/// one. Throws Error where its file cannot be read.
std::string authored_provenance(const std::optional<std::string>& character, bool with_startle);

}  // namespace flinch::database
