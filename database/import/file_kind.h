// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace flinch::database {

/// Bytes from the beginning of a file that are enough to judge its kind.
inline constexpr std::size_t kFileOpening = 64 * 1024;

/// Kind of a file, judged by its first bytes. A BVH file may have blank lines and comments first.
enum class FileKind : std::uint8_t {
  empty,
  library,
  selector,
  store,  ///< or another SQLite database
  bvh,
  gltf,
  archive,  ///< zip, gzip or xz
  text,
  unknown,
};

FileKind file_kind_of(std::string_view bytes);

/// Returns the kind with its article, such as "a library" or "a BVH file".
std::string_view name_of(FileKind kind);

}  // namespace flinch::database
