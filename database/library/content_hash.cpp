// SPDX-License-Identifier: MIT
#include "database/library/content_hash.h"

#include <array>
#include <bit>

namespace flinch::database {
namespace {

using std::rotl;
using std::uint64_t;

constexpr uint64_t kPrime1 = 0x9E3779B185EBCA87;
constexpr uint64_t kPrime2 = 0xC2B2AE3D27D4EB4F;
constexpr uint64_t kPrime3 = 0x165667B19E3779F9;
constexpr uint64_t kPrime4 = 0x85EBCA77C2B2AE63;
constexpr uint64_t kPrime5 = 0x27D4EB2F165667C5;

/// Removes `size` bytes from the front and returns them as a little-endian number.
template <std::size_t size>
uint64_t take(std::span<const std::byte>& bytes) {
  uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= std::to_integer<uint64_t>(bytes[i]) << (8 * i);
  }
  bytes = bytes.subspan(size);
  return number;
}

uint64_t mix(uint64_t lane, uint64_t input) {
  return rotl(lane + input * kPrime2, 31) * kPrime1;
}

/// Removes stripes of 32 bytes from the front and adds one word of each to each of four lanes,
/// which the processor computes in parallel.
uint64_t hash_stripes(std::span<const std::byte>& bytes) {
  std::array<uint64_t, 4> lanes{kPrime1 + kPrime2, kPrime2, 0, 0 - kPrime1};
  while (bytes.size() >= 32) {
    for (uint64_t& lane : lanes) lane = mix(lane, take<8>(bytes));
  }
  uint64_t hash = rotl(lanes[0], 1) + rotl(lanes[1], 7) + rotl(lanes[2], 12) + rotl(lanes[3], 18);
  for (const uint64_t lane : lanes) hash = (hash ^ mix(0, lane)) * kPrime1 + kPrime4;
  return hash;
}

}  // namespace

// https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md, "XXH64 algorithm description".
uint64_t content_hash(std::span<const std::byte> bytes) noexcept {
  const uint64_t size = bytes.size();
  uint64_t hash = size >= 32 ? hash_stripes(bytes) : kPrime5;
  hash += size;
  while (bytes.size() >= 8) hash = rotl(hash ^ mix(0, take<8>(bytes)), 27) * kPrime1 + kPrime4;
  if (bytes.size() >= 4) hash = rotl(hash ^ (take<4>(bytes) * kPrime1), 23) * kPrime2 + kPrime3;
  while (!bytes.empty()) hash = rotl(hash ^ (take<1>(bytes) * kPrime5), 11) * kPrime1;
  hash = (hash ^ (hash >> 33)) * kPrime2;
  hash = (hash ^ (hash >> 29)) * kPrime3;
  return hash ^ (hash >> 32);
}

}  // namespace flinch::database
