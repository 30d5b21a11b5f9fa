// SPDX-License-Identifier: MIT
#include "database/sealed_file.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

namespace flinch::database {
namespace {

constexpr std::size_t kMarkSize = 7;
constexpr std::size_t kHashPosition = kMarkSize + 1;

}  // namespace

const char* message_of(LoadStatus status) noexcept {
  switch (status) {
    case LoadStatus::ok:
      return "is sound";
    case LoadStatus::cannot_open:
      return "cannot be read";
    case LoadStatus::not_a_library:
      return "is another kind of file";
    case LoadStatus::other_version:
      return "was written by another version of Flinch";
    case LoadStatus::damaged:
      return "is damaged or cut short";
    case LoadStatus::other_layout:
      return "was trained on other features than this version of Flinch computes";
    case LoadStatus::out_of_memory:
      return "does not fit into memory";
  }
  return "has an unknown status";
}

// http://www.isthe.com/chongo/tech/comp/fnv/ : for each byte, hash = (hash xor byte) * prime.
// Both steps are one to one, so two contents that differ in one byte never share a hash.
std::uint64_t content_hash(std::span<const std::byte> bytes) noexcept {
  constexpr std::uint64_t kOffsetBasis = 0xCBF29CE484222325;
  constexpr std::uint64_t kPrime = 0x00000100000001B3;
  std::uint64_t hash = kOffsetBasis;
  for (const std::byte byte : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * kPrime;
  return hash;
}

std::array<std::byte, kSealSize> make_seal(const SealedKind& kind,
                                           std::span<const std::byte> content) noexcept {
  std::array<std::byte, kSealSize> seal{};
  std::transform(kind.mark.begin(), kind.mark.begin() + kMarkSize, seal.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  seal[kMarkSize] = static_cast<std::byte>(kind.version);
  const std::uint64_t hash = content_hash(content);
  for (std::size_t i = 0; i < sizeof(hash); ++i) {
    seal[kHashPosition + i] = static_cast<std::byte>(hash >> (8 * i));
  }
  return seal;
}

Unsealed unseal(const SealedKind& kind, std::span<const std::byte> file) noexcept {
  const auto same = [](std::byte byte, char c) { return byte == static_cast<std::byte>(c); };
  const auto mark = file.first(std::min(file.size(), kMarkSize));
  if (!std::equal(mark.begin(), mark.end(), kind.mark.begin(), kind.mark.end(), same)) {
    return {.status = LoadStatus::not_a_library};
  }
  if (file.size() < kSealSize) return {.status = LoadStatus::damaged};
  if (file[kMarkSize] != static_cast<std::byte>(kind.version)) {
    return {.status = LoadStatus::other_version};
  }
  const auto content = file.subspan(kSealSize);
  const auto seal = make_seal(kind, content);
  if (!std::equal(seal.begin(), seal.end(), file.begin())) return {.status = LoadStatus::damaged};
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < sizeof(hash); ++i) {
    hash |= std::to_integer<std::uint64_t>(seal[kHashPosition + i]) << (8 * i);
  }
  return {.status = LoadStatus::ok, .hash = hash, .content = content};
}

LoadStatus read_bytes(const std::string& path, std::vector<std::byte>& bytes) noexcept try {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (!file) return LoadStatus::cannot_open;
  std::vector<std::byte> read;
  constexpr std::size_t kChunk = 1 << 16;
  std::size_t count = kChunk;
  while (count == kChunk) {
    const std::size_t size = read.size();
    read.resize(size + kChunk);
    count = std::fread(read.data() + size, 1, kChunk, file.get());
    read.resize(size + count);
  }
  if (std::ferror(file.get()) != 0) return LoadStatus::cannot_open;
  bytes = std::move(read);
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

}  // namespace flinch::database
