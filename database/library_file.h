// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "database/library.h"

namespace flinch::database {

/// What was wrong with a file, or nothing.
enum class LoadStatus : std::uint8_t {
  ok,
  cannot_open,
  not_a_library,  ///< not this kind of file
  other_version,  ///< written by another version of the format
  damaged,        ///< fails verification or its content hash
};
const char* message_of(LoadStatus status);

/// Reads a library from a file's bytes. The bytes are verified whole, against the schema, the
/// content hash and the invariants of Library, before anything is used. On failure `library` is
/// left as it was. Throws nothing.
LoadStatus read_library(std::span<const std::byte> bytes, Library& library) noexcept;

/// The same from a file.
LoadStatus read_library(const std::string& path, Library& library) noexcept;

/// FNV-1a, 64 bit, over the bytes: the content hash of library and selector files. Guards against
/// accidents, not against intent.
std::uint64_t content_hash(std::span<const std::byte> bytes);

}  // namespace flinch::database
