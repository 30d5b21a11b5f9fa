// SPDX-License-Identifier: MIT
#include "database/library/text_check.h"

#include <cstddef>
#include <cstdint>

namespace flinch::database {
namespace {

/// Returns the size of the character at the front of `text` in bytes, or 0 unless it is printable
/// UTF-8: the shortest encoding of a code point below U+110000 that is neither a surrogate nor a
/// control character.
std::size_t printable_size(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return static_cast<unsigned char>(text[i]);
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC0 || first >= 0xF8 || text.size() < size) return 0;
  std::uint32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0xA0, 0x800, 0x10000};  // U+0080 to U+009F control
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  return code >= kSmallest[size] && code < 0x110000 && !is_surrogate ? size : 0;
}

}  // namespace

bool is_printable(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    if (size > 0) {
      shown.append(text.substr(0, size));
    } else {
      shown += '?';
    }
    text.remove_prefix(size > 0 ? size : 1);
  }
  return shown;
}

}  // namespace flinch::database
