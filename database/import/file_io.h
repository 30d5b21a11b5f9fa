// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::database {

/// A whole file's bytes. Throws Error when it is missing, a directory or cannot be read.
std::string read_file(const std::string& path);

/// Writes a whole file or nothing: the bytes go to "PATH.partial" on the same disk, are forced
/// out to it, and take the final name only then, so that neither a full disk nor an interruption
/// leaves half a file under that name. On failure the partial file is removed, what stood under
/// the name before stays, and Error says why and what to do.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace flinch::database
