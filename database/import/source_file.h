// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/import/bvh.h"

namespace flinch::database {

/// Reads motion capture from a BVH, FBX or glTF file; the content decides which it is. Throws
/// Error.
Bvh read_source_file(const std::string& path);

}  // namespace flinch::database
