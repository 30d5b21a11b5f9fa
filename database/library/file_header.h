// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "database/library/content_hash.h"
#include "database/library/input_file.h"
#include "database/library/load_status.h"

namespace flinch::database {

/// Library and selector files begin with a header: 7 characters that name the kind, one byte for
/// the version, and the content hash of all that follows in 8 bytes, least significant first. Then
/// comes the content. One wrong byte anywhere, or a truncated end, is detected.
struct FileFormat {
  std::string_view magic;              ///< 7 characters
  std::uint8_t version = 1;            ///< that is written
  std::uint8_t newest_read = version;  ///< the last of those that are read; `version` is the first
};
/// Version 4 is that of libraries whose poses are all on the grid of pose_grid.h, as authored and
/// imported ones are. Others are written in version 3 if they have stances and in version 2 if not,
/// to the same bytes as ever.
inline constexpr FileFormat kLibraryFormat{.magic = "FLINCHL", .version = 2, .newest_read = 4};
inline constexpr std::uint8_t kStanceVersion = 3;
inline constexpr std::uint8_t kPackedVersion = 4;
inline constexpr FileFormat kSelectorFormat{.magic = "FLINCHS", .version = 3};

inline constexpr std::size_t kFileHeaderSize = 16;

/// Returns the text's bytes, valid as long as the text.
inline std::span<const std::byte> bytes_of(std::string_view text) noexcept {
  return std::as_bytes(std::span(text));
}

/// Returns the header that precedes `content` in its file.
std::array<std::byte, kFileHeaderSize> make_file_header(
    const FileFormat& kind, std::span<const std::byte> content) noexcept;

/// A file's content, once its header has been verified.
struct VerifiedFile {
  LoadStatus status = LoadStatus::damaged;
  std::uint8_t version = 0;                 ///< of those that the format reads
  std::uint64_t hash = 0;                   ///< of the content
  std::span<const std::byte> content = {};  ///< inside the file's bytes; empty unless ok
};
/// Verifies size, kind, version and content hash.
VerifiedFile verify_file(const FileFormat& kind, std::span<const std::byte> file) noexcept;

/// The same except the content hash, which is read from the header and not compared.
VerifiedFile parse_file(const FileFormat& kind, std::span<const std::byte> file) noexcept;

/// Returns the bytes aligned so that FlatBuffers can read them in place: where they are if that is
/// aligned, otherwise copied to `storage`.
std::span<const std::byte> aligned(std::span<const std::byte> bytes,
                                   std::vector<std::byte>& storage);

}  // namespace flinch::database
