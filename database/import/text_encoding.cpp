// SPDX-License-Identifier: MIT
#include "database/import/text_encoding.h"

#include <cstddef>
#include <cstdint>

namespace flinch::database {
namespace {

std::uint8_t byte_of(char c) {
  return static_cast<std::uint8_t>(c);
}

bool is_continuation(char c) {
  return (byte_of(c) & 0xC0) == 0x80;
}

/// Returns the number of bytes of the character that `text` begins with; 0 if it is not UTF-8. See
/// RFC 3629, section 4.
std::size_t character_size(std::string_view text) {
  const std::uint8_t first = byte_of(text[0]);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const std::uint8_t second = byte_of(text[1]);
  if (first == 0xE0 && second < 0xA0) return 0;   // overlong
  if (first == 0xED && second >= 0xA0) return 0;  // surrogates
  if (first == 0xF0 && second < 0x90) return 0;   // overlong
  if (first == 0xF4 && second >= 0x90) return 0;  // above U+10FFFF
  return size;
}

bool is_control(std::string_view character) {
  const std::uint8_t first = byte_of(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  return first == 0xC2 && byte_of(character[1]) < 0xA0;  // U+0080 to U+009F
}

std::string utf8_from_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const std::uint8_t byte = byte_of(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | (byte >> 6));
      text += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return text;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t size = character_size(bytes);
    if (size == 0) return false;
    bytes.remove_prefix(size);
  }
  return true;
}

std::string printable_text(std::string_view bytes) {
  const std::string text = is_utf8(bytes) ? std::string(bytes) : utf8_from_latin1(bytes);
  std::string printable;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view character = rest.substr(0, character_size(rest));
    printable += is_control(character) ? "?" : character;
    rest.remove_prefix(character.size());
  }
  return printable;
}

}  // namespace flinch::database
