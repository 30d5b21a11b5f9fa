// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::database {

/// Returns a whole file's bytes. Throws Error when it is missing, is a directory or cannot be read.
std::string read_file(const std::string& path);

/// Writes a file atomically: writes the bytes to "PATH.partial" on the same disk, flushes them to
/// the disk, and only then renames the file, so that neither a full disk nor an interruption leaves
/// a partial file at `path`. On failure the partial file is removed, an existing file at `path` is
/// unchanged, and the Error says why and what to do.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace flinch::database
