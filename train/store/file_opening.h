// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/files/file_kind.h"

namespace flinch::train {

/// Returns the kind of the file at a path, from its first bytes, whatever its size. Throws Error if
/// it is missing, no regular file or cannot be read.
database::FileKind file_kind_at(const std::string& path);

}  // namespace flinch::train
