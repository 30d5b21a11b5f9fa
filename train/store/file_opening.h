// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/import/file_kind.h"

namespace flinch::train {

/// What the file at a path is, by its first bytes: however large it is, little of it is read.
/// Throws Error when it is missing, a folder or cannot be read.
database::FileKind file_kind_at(const std::string& path);

}  // namespace flinch::train
