// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace flinch::database {

/// Returns XXH64 of the bytes with seed 0, the number that `xxhsum -H64` prints: the content hash
/// of library and selector files. Detects accidental damage, not tampering.
std::uint64_t content_hash(std::span<const std::byte> bytes) noexcept;

}  // namespace flinch::database
