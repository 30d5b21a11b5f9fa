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

namespace flinch::database {

/// What was wrong with a file, or nothing.
enum class LoadStatus : std::uint8_t {
  ok,
  cannot_open,
  not_a_library,  ///< not the kind of file that was asked for
  other_version,  ///< written by another version of the format
  damaged,        ///< fails verification or its content hash
  other_layout,   ///< a selector of other features than this build computes
  without_clips,  ///< a selector that has no clips in its file
  out_of_memory,
};
/// What it means, for people; never null.
const char* message_of(LoadStatus status) noexcept;

/// Libraries and selectors are sealed files: 7 characters that name the kind, one byte of version,
/// the content hash of all that follows in 8 bytes, least significant first, and then the content.
/// One wrong byte anywhere, or a missing end, is noticed.
struct FileFormat {
  std::string_view magic;  ///< 7 characters
  std::uint8_t version = 1;
};
inline constexpr FileFormat kLibraryFormat{.magic = "FLINCHL", .version = 2};
inline constexpr FileFormat kSelectorFormat{.magic = "FLINCHS", .version = 3};

inline constexpr std::size_t kFileHeaderSize = 16;

/// The text's bytes, as long as it lives.
inline std::span<const std::byte> bytes_of(std::string_view text) noexcept {
  return std::as_bytes(std::span(text));
}

/// The bytes that go before `content` in its file.
std::array<std::byte, kFileHeaderSize> make_file_header(
    const FileFormat& kind, std::span<const std::byte> content) noexcept;

/// A file's content, once its seal has been found whole.
struct VerifiedFile {
  LoadStatus status = LoadStatus::damaged;
  std::uint64_t hash = 0;                   ///< of the content
  std::span<const std::byte> content = {};  ///< inside the file's bytes; empty unless ok
};
/// Checks kind, version and content hash.
VerifiedFile verify_file(const FileFormat& kind, std::span<const std::byte> file) noexcept;

/// The same for a file that stands inside another one whose seal was found whole: that seal covers
/// these bytes, so their hash is taken from their own seal and not computed again.
VerifiedFile verify_embedded_file(const FileFormat& kind, std::span<const std::byte> file) noexcept;

/// The bytes where FlatBuffers can read them in place, which wants its numbers aligned: where they
/// are if that will do, else copied to `storage`.
std::span<const std::byte> aligned(std::span<const std::byte> bytes,
                                   std::vector<std::byte>& storage);

/// A whole file into `bytes`, which are aligned for FlatBuffers. Throws nothing.
LoadStatus read_bytes(const std::string& path, std::vector<std::byte>& bytes) noexcept;

}  // namespace flinch::database
