// SPDX-License-Identifier: MIT
#include "database/library/file_header.h"

#include <algorithm>

namespace flinch::database {
namespace {

constexpr std::size_t kMagicSize = 7;
constexpr std::size_t kHashPosition = kMagicSize + 1;

}  // namespace

std::array<std::byte, kFileHeaderSize> make_file_header(
    const FileFormat& kind, std::span<const std::byte> content) noexcept {
  std::array<std::byte, kFileHeaderSize> seal{};
  std::transform(kind.magic.begin(), kind.magic.begin() + kMagicSize, seal.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  seal[kMagicSize] = static_cast<std::byte>(kind.version);
  const std::uint64_t hash = content_hash(content);
  for (std::size_t i = 0; i < sizeof(hash); ++i) {
    seal[kHashPosition + i] = static_cast<std::byte>(hash >> (8 * i));
  }
  return seal;
}

VerifiedFile parse_file(const FileFormat& kind, std::span<const std::byte> file) noexcept {
  const auto same = [](std::byte byte, char c) { return byte == static_cast<std::byte>(c); };
  const auto mark = file.first(std::min(file.size(), kMagicSize));
  if (!std::equal(mark.begin(), mark.end(), kind.magic.begin(), kind.magic.end(), same)) {
    return {.status = LoadStatus::not_a_library};
  }
  if (file.size() < kFileHeaderSize) return {.status = LoadStatus::damaged};
  const auto version = std::to_integer<std::uint8_t>(file[kMagicSize]);
  if (version < kind.version || version > kind.newest_read) {
    return {.status = LoadStatus::other_version};
  }
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < sizeof(hash); ++i) {
    hash |= std::to_integer<std::uint64_t>(file[kHashPosition + i]) << (8 * i);
  }
  return {.status = LoadStatus::ok,
          .version = version,
          .hash = hash,
          .content = file.subspan(kFileHeaderSize)};
}

VerifiedFile verify_file(const FileFormat& kind, std::span<const std::byte> file) noexcept {
  if (file.size() > kMaxFileSize) return {.status = LoadStatus::too_large};
  const VerifiedFile unsealed = parse_file(kind, file);
  if (unsealed.status != LoadStatus::ok || unsealed.hash == content_hash(unsealed.content)) {
    return unsealed;
  }
  return {.status = LoadStatus::damaged};
}

std::span<const std::byte> aligned(std::span<const std::byte> bytes,
                                   std::vector<std::byte>& storage) {
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(std::max_align_t) == 0) return bytes;
  storage.assign(bytes.begin(), bytes.end());
  return storage;
}

}  // namespace flinch::database
