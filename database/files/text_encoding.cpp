// SPDX-License-Identifier: MIT
#include "database/files/text_encoding.h"

#include <cstdint>

namespace flinch::database {
namespace {

std::string utf8_from_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
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
