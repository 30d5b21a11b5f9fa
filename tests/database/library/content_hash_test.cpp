// SPDX-License-Identifier: MIT
#include "database/library/content_hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace flinch::database {
namespace {

std::uint64_t hash_of(const std::string& text) {
  return content_hash(std::as_bytes(std::span(text)));
}

/// `count` bytes 0, 1, 2, …, 255, 0, …
std::string counting(std::size_t count) {
  std::string bytes(count, '\0');
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i);
  return bytes;
}

// Results of libxxhash 0.8.1 for each path through the algorithm: nothing, single bytes, a half
// word, a word, all of these, only stripes, and stripes with a tail.
TEST(ContentHash, MatchesXxh64) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999U);
  EXPECT_EQ(hash_of("foobar"), 0xA2AA05ED9085AAF9U);
  EXPECT_EQ(hash_of("12345678"), 0xD2D02F08CF7CFD4AU);
  EXPECT_EQ(hash_of(counting(31)), 0xC346D2B59B4D8EE1U);
  EXPECT_EQ(hash_of(counting(32)), 0xCBF59C5116FF32B4U);
  EXPECT_EQ(hash_of(counting(3 * 256) + "tail of 13 by"), 0xC193CBDBA17BA7FEU);
}

TEST(ContentHash, ChangesWithEveryBitAndEveryLength) {
  std::string bytes = counting(77);
  std::set<std::uint64_t> hashes{hash_of(bytes)};
  for (char& byte : bytes) {
    for (int bit = 0; bit < 8; ++bit) {
      byte = static_cast<char>(byte ^ (1 << bit));
      EXPECT_TRUE(hashes.insert(hash_of(bytes)).second);
      byte = static_cast<char>(byte ^ (1 << bit));
    }
  }
  for (std::size_t size = 0; size < 200; ++size)
    EXPECT_TRUE(hashes.insert(hash_of(std::string(size, '\0'))).second) << size << " zeros";
}

// A hash that only combines whole words would miss this: the signs of two numbers, each the top bit
// of a word.
TEST(ContentHash, ChangesWhenTwoSignBitsFlip) {
  std::string bytes = counting(640);
  std::set<std::uint64_t> hashes{hash_of(bytes)};
  for (std::size_t i = 7; i < bytes.size(); i += 8) {
    for (std::size_t j = 7; j < i; j += 8) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ 0x80);
      changed[j] = static_cast<char>(changed[j] ^ 0x80);
      EXPECT_TRUE(hashes.insert(hash_of(changed)).second);
    }
  }
}

}  // namespace
}  // namespace flinch::database
