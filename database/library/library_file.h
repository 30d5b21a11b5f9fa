// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "database/library/file_header.h"
#include "database/library/library.h"

namespace flinch::database {

/// Reads a library from a file's bytes. The bytes are verified whole, against the content hash, the
/// schema and the invariants below, before anything is used. On failure `library` is left as it
/// was. Throws nothing.
LoadStatus read_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept;

/// The same from a file.
LoadStatus read_library(const std::string& path, ClipLibrary& library) noexcept;

/// The same from the bytes of a library file that stands inside another sealed file, which was
/// found whole; see verify_embedded_file().
LoadStatus read_embedded_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept;

/// Why a library could not be used.
struct LibraryFault {
  std::optional<std::size_t> clip;  ///< index of the clip that is at fault, if one is
  const char* what = "";
};

/// The first thing that breaks what the code relies on, if anything does: names that are not empty,
/// those of clips all different; a rate and a mass above 0; an idle clip among the clips; at least
/// one pose a clip, at the library's rate; finite numbers; unit rotations (to 1e-3); annotations in
/// their ranges (times to 0.1 ms, see motion::Annotation).
std::optional<LibraryFault> fault_of(const ClipLibrary& library);

}  // namespace flinch::database
