// SPDX-License-Identifier: MIT
#include "database/files/toml_string.h"

#include <array>
#include <cstdio>

namespace flinch::database {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') result += '\\';
    if (code < 0x20 || code == 0x7F) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04X", unsigned{code});
      result += escape.data();
    } else {
      result += character;
    }
  }
  return result + '"';
}

}  // namespace flinch::database
