// SPDX-License-Identifier: MIT
#include "database/files/text_encoding.h"

#include <gtest/gtest.h>

#include <string>

namespace flinch::database {
namespace {

std::string bytes_of(std::uint32_t code, int size) {
  if (size == 1) return {static_cast<char>(code)};
  constexpr std::uint32_t kLead[] = {0, 0, 0xC0, 0xE0, 0xF0};
  std::string text;
  text += static_cast<char>(kLead[size] | (code >> (6 * (size - 1))));
  for (int i = size - 2; i >= 0; --i) text += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3F));
  return text;
}

TEST(TextEncoding, EveryCodePointIsUtf8InItsShortestFormAlone) {
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    const int shortest = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    ASSERT_EQ(is_utf8(bytes_of(code, shortest)), !is_surrogate) << code;
    if (shortest == 4) continue;
    ASSERT_FALSE(is_utf8(bytes_of(code, shortest + 1))) << code;
  }
  EXPECT_FALSE(is_utf8(bytes_of(0x110000, 4)));
  EXPECT_TRUE(is_utf8(""));
}

TEST(TextEncoding, CharactersThatAreCutOrContinueNothingAreNotUtf8) {
  for (const std::string text :
       {"\x80", "\xC3", "\xE5\xB7", "\xF0\x9F\x98", "a\xFF", "\xC3(", "\xC3\xA9\xA9"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
  }
}

TEST(TextEncoding, AnyBytesBecomePrintableUtf8) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  const std::string text = printable_text(all);
  EXPECT_TRUE(is_utf8(text));
  EXPECT_EQ(text.substr(0, 32), std::string(32, '?'));
  EXPECT_EQ(text.substr(32, 3), " !\"");
  EXPECT_EQ(text.substr(text.size() - 4), "\u00FE\u00FF");
  for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F);
}

TEST(TextEncoding, Utf8StaysAsItIsButForControlCharacters) {
  EXPECT_EQ(printable_text("\u5DE6\u8155 \u00E9 \U0001F600"), "\u5DE6\u8155 \u00E9 \U0001F600");
  EXPECT_EQ(printable_text("a\nb\x1B[31m\u009Bc\x7F"), "a?b?[31m?c?");
}

}  // namespace
}  // namespace flinch::database
