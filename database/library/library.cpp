// SPDX-License-Identifier: MIT
#include "database/library/library.h"

#include <string_view>

namespace flinch::database {

std::string hash_text(std::uint64_t hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = kDigits[(hash >> (60 - 4 * i)) & 0xF];
  return text;
}

}  // namespace flinch::database
