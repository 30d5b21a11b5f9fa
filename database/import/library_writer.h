// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "database/library/library.h"

namespace flinch::database {

/// The bytes of a library's file: the same for the same library. `library.hash` is not looked at.
/// Throws Error when the library breaks its invariants (see library_file.h), so that nothing is
/// written that would not be read.
std::string library_bytes(const ClipLibrary& library);

/// Writes the file whole or not at all and returns its content hash. Throws Error.
std::uint64_t write_library(const ClipLibrary& library, const std::string& path);

/// Reads a library file for offline code. Throws Error that says what is wrong, and what the file
/// is instead where that can be told.
ClipLibrary load_library(const std::string& path);

}  // namespace flinch::database
