// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flinch::database {

/// Returns a whole file's bytes, as database::read_bytes() reads them. Throws Error when it is
/// missing, no regular file, larger than kMaxFileSize or cannot be read.
std::string read_file(const std::string& path);

/// Returns the first `size` bytes, or all if there are fewer, of a regular file of any size. Throws
/// Error as read_file does.
std::string read_file_start(const std::string& path, std::size_t size);

/// Writes a file atomically: writes the bytes to "PATH.partial" in the same folder, flushes them to
/// the disk, and only then renames the file (see PartialFile), so that neither a full disk nor an
/// interruption leaves a partial file at `path`. If `path` is a link, it remains, and the file that
/// it leads to is replaced. On failure the partial file is removed, an existing file at `path` is
/// unchanged, and the Error says why and what to do.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace flinch::database
