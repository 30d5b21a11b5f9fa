// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "database/library/load_status.h"

namespace flinch::database {

/// Files above this size are not read into memory: 1 GiB. FlatBuffers can address twice that.
inline constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;

/// Reads a whole file into `bytes`, which are aligned for FlatBuffers. Every input of Flinch that
/// is held in memory is read by this function: only regular files, since devices and pipes may
/// never end, and only up to kMaxFileSize. On `cannot_open`, errno says why. On failure `bytes` are
/// unchanged. Does not throw.
LoadStatus read_bytes(const std::string& path, std::vector<std::byte>& bytes) noexcept;
LoadStatus read_bytes(const std::string& path, std::string& bytes) noexcept;

/// Reads the first `size` bytes, or all if there are fewer, of a regular file of any size.
LoadStatus read_first_bytes(const std::string& path, std::size_t size, std::string& bytes) noexcept;

}  // namespace flinch::database
