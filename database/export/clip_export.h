// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/export/gltf_writer.h"
#include "database/library/library.h"

namespace flinch::database {

/// Returns every clip of a library in its order, each with its annotation, under a name that tools
/// and file systems take as it is: in lower case, with "_" in place of all that is no ASCII letter
/// or digit, and with "_2", "_3", ... behind it where an earlier clip has the same.
std::vector<NamedMotion> exported_clips(const ClipLibrary& library);

}  // namespace flinch::database
