// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "database/library/file_header.h"
#include "database/library/library.h"

namespace flinch::database {

/// Reads a library from a file's bytes. All bytes are verified against the content hash, the schema
/// and the invariants below before any is used. On failure `library` is unchanged. Does not throw.
LoadStatus read_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept;

/// The same from a file.
LoadStatus read_library(const std::string& path, ClipLibrary& library) noexcept;

/// The same for a library within another file, whose hash has been compared and covers these bytes.
/// So they are not damaged: if the library's own hash differs, it was put there for another one,
/// and the status is LoadStatus::other_content.
LoadStatus read_embedded_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept;

/// The version of a file whose poses are floats: kStanceVersion if the library has stances, else
/// the first.
std::uint8_t float_version_of(const ClipLibrary& library);

/// The most bytes of poses that a library with this much content may hold. Packed poses and mirror
/// images take less room in a file than in memory, usually a seventh to a tenth; a forged file
/// could claim any number.
constexpr std::uint64_t max_unpacked_size(std::size_t content_size) {
  constexpr std::uint64_t kMaxRatio = 16;
  constexpr std::uint64_t kAnyFile = std::uint64_t{32} << 20;
  return kMaxRatio * content_size + kAnyFile;
}

/// Why a library could not be used.
struct LibraryFault {
  std::optional<std::size_t> clip;  ///< index of the faulty clip, if it is one
  const char* what = "";
};

/// Returns the first violated invariant, if any. Clip names are unique; the idle clip is one of the
/// clips; every clip has at least one pose and the library's rate; stances loop; rotations are unit
/// (to 1e-3); annotations are in their ranges (times to 0.1 ms, see motion::Annotation); all
/// numbers, counts and texts are within the bounds of library_bounds.h.
std::optional<LibraryFault> fault_of(const ClipLibrary& library);

}  // namespace flinch::database
