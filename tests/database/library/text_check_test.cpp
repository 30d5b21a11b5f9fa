// SPDX-License-Identifier: MIT
#include "database/library/text_check.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace flinch::database {
namespace {

/// The encoding that the standard gives for a code point: the oracle for one that is printable.
std::string utf8_of(std::uint32_t code) {
  const auto tail = [code](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 | code >> 6), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 | code >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

TEST(TextCheck, AcceptsEveryCodePointButControlsAndSurrogates) {
  for (std::uint32_t code = 0; code < 0x110000; ++code) {
    const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    ASSERT_EQ(is_printable("a" + utf8_of(code) + "z"), !is_control && !is_surrogate) << code;
  }
}

TEST(TextCheck, RefusesBytesThatAreNotUtf8) {
  for (const char* wrong :
       {"\x80", "\xC3", "\xC3(", "\xE2\x82", "\xF0\x9F\x98", "\xFF", "\xFE", "\xF8\x88\x80\x80\x80",
        "\xC0\xAF", "\xC1\x81", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80"}) {
    EXPECT_FALSE(is_printable(wrong));
    EXPECT_FALSE(is_printable(std::string("name") + wrong));
  }
}

}  // namespace
}  // namespace flinch::database
