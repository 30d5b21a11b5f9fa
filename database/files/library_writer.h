// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "database/library/library.h"

namespace flinch::database {

/// Returns the bytes of a library's file; the same for the same library. Ignores `library.hash`.
/// Without its provenance it is as stores and selectors hold it, and the hash of what follows the
/// header is the library's.
/// Throws Error when the library breaks its invariants (see library_file.h), so that every file
/// written can be read.
std::string library_bytes(const ClipLibrary& library);
std::string bare_library_bytes(const ClipLibrary& library);

/// Writes the file atomically and returns the library's hash. Throws Error.
std::uint64_t write_library(const ClipLibrary& library, const std::string& path);

/// Reads a library file for offline code. Throws Error that says what is wrong and, if it can be
/// detected, which kind of file it is instead.
ClipLibrary load_library(const std::string& path);

}  // namespace flinch::database
