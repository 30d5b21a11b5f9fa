// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace flinch::database {

namespace schema {
struct Library;
}

/// Returns the hash that a library's file would have without its provenance, by which stores and
/// selectors know the library. `stored` is the verified table of `content`. None if the parts of
/// the content are not in the order in which files are written. Throws bad_alloc.
std::optional<std::uint64_t> bare_hash_of(const schema::Library& stored,
                                          std::span<const std::byte> content);

}  // namespace flinch::database
