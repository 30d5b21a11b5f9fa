// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "database/library/file_header.h"

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
  fbx,
  gltf,     ///< binary or text
  archive,  ///< zip, gzip or xz
  utf16,    ///< text that no reader takes
  text,
  unknown,
};

FileKind file_kind_of(std::string_view bytes);

/// Whether a name, where what is shipped has names too, is that of a TOML file: it ends in ".toml".
bool names_toml_file(std::string_view name);

/// Returns why a file was refused that is of this format: the status' message, or the two versions
/// if they differ.
std::string refusal_of(LoadStatus status, const FileFormat& format, std::string_view file);

/// Whether files of this kind may hold motion capture.
bool holds_motion(FileKind kind);

/// Returns the kind with its article, such as "a library" or "a BVH file".
std::string_view name_of(FileKind kind);

/// Returns the kind as one word, such as "library" or "bvh".
std::string_view word_of(FileKind kind);

/// Throws Error for text in UTF-16, of a file that should be text.
void require_not_utf16(std::string_view bytes, const std::string& path);

}  // namespace flinch::database
