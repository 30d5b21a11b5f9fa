// SPDX-License-Identifier: MIT
#include "database/library/text_check.h"

#include <cstdint>

namespace flinch::database {
namespace {

std::uint8_t byte_of(char c) noexcept {
  return static_cast<std::uint8_t>(c);
}

}  // namespace

std::size_t character_size(std::string_view text) noexcept {
  const std::uint8_t first = byte_of(text[0]);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_of(text[i]) & 0xC0) != 0x80) return 0;
  }
  const std::uint8_t second = byte_of(text[1]);
  if (first == 0xE0 && second < 0xA0) return 0;   // overlong
  if (first == 0xED && second >= 0xA0) return 0;  // surrogates
  if (first == 0xF0 && second < 0x90) return 0;   // overlong
  if (first == 0xF4 && second >= 0x90) return 0;  // above U+10FFFF
  return size;
}

bool is_control(std::string_view character) noexcept {
  const std::uint8_t first = byte_of(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  return first == 0xC2 && byte_of(character[1]) < 0xA0;  // U+0080 to U+009F
}

bool is_utf8(std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const std::size_t size = character_size(bytes);
    if (size == 0) return false;
    bytes.remove_prefix(size);
  }
  return true;
}

bool is_printable(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    if (size == 0 || is_control(text.substr(0, size))) return false;
    text.remove_prefix(size);
  }
  return true;
}

}  // namespace flinch::database
