// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "database/library/file_header.h"

// Damage to files, for tests of their readers. A test without any case fails.
namespace flinch::tests {

/// A change to one byte of a file: some of its bits are flipped.
struct Flip {
  std::size_t byte = 0;
  int bits = 1;  ///< 1 to 255
};

/// Returns flips of each single bit of a file of `size` bytes.
inline std::vector<Flip> every_bit(std::size_t size) {
  std::vector<Flip> flips;
  for (std::size_t byte = 0; byte < size; ++byte) {
    for (int bit = 0; bit < 8; ++bit) flips.push_back({byte, 1 << bit});
  }
  return flips;
}

/// Returns flips that change each of these bytes to a random other value.
template <class Random>
std::vector<Flip> random_flips(const std::vector<std::size_t>& bytes, Random& random) {
  std::vector<Flip> flips;
  for (const std::size_t byte : bytes)
    flips.push_back({byte, 1 + static_cast<int>(random() % 255)});
  return flips;
}

/// Returns positions in a file of `size` bytes: each of the first `dense`, then every `step`-th.
inline std::vector<std::size_t> places(std::size_t size, std::size_t step = 1,
                                       std::size_t dense = 0) {
  std::vector<std::size_t> all;
  for (std::size_t at = 0; at < size; at += at < dense ? 1 : step) all.push_back(at);
  return all;
}

/// Calls `check` for each flip with the changed file and the flip.
template <class Check>
void for_each_flip(std::string file, const std::vector<Flip>& flips, Check check) {
  ASSERT_FALSE(flips.empty());
  for (const Flip& flip : flips) {
    ASSERT_LT(flip.byte, file.size());
    const char whole = file[flip.byte];
    file[flip.byte] = static_cast<char>(whole ^ static_cast<char>(flip.bits));
    ASSERT_NE(file[flip.byte], whole);
    check(std::as_const(file), flip);
    if (testing::Test::HasFatalFailure()) return;
    file[flip.byte] = whole;
  }
}

/// Fails unless `is_refused` returns true for the file after each flip.
template <class IsRefused>
void expect_flips_are_refused(const std::string& file, const std::vector<Flip>& flips,
                              IsRefused is_refused) {
  for_each_flip(file, flips, [&](const std::string& flipped, const Flip& flip) {
    ASSERT_TRUE(is_refused(flipped)) << "byte " << flip.byte << ", bits " << flip.bits;
  });
}

/// Fails unless `is_refused` returns true for the file truncated to each of these sizes, and for
/// the file with one byte appended.
template <class IsRefused>
void expect_wrong_sizes_are_refused(const std::string& file, const std::vector<std::size_t>& sizes,
                                    IsRefused is_refused) {
  ASSERT_FALSE(sizes.empty());
  for (const std::size_t size : sizes) {
    ASSERT_LT(size, file.size());
    ASSERT_TRUE(is_refused(file.substr(0, size))) << "cut to " << size << " bytes";
  }
  EXPECT_TRUE(is_refused(file + '\0')) << "a byte too many";
}

/// Returns the content of a file, after its header.
inline std::string content_of(const std::string& file) {
  return file.substr(database::kFileHeaderSize);
}

/// Returns the content with a valid header, so that only the checks of the content can reject it.
inline std::string with_header(const database::FileFormat& format, const std::string& content) {
  const auto header = database::make_file_header(format, database::bytes_of(content));
  return std::string(reinterpret_cast<const char*>(header.data()), header.size()) + content;
}

/// Number of damaged files that a reader rejected and that it read.
struct ReadCounts {
  int refused = 0;
  int read = 0;
};

/// Damages the content of a file `count` times and gives it a valid header. `damage` changes a copy
/// of the content with a random generator; `reads` returns whether the file is read, and checks the
/// result.
template <class Damage, class Reads>
ReadCounts try_damaged_content(const database::FileFormat& format, const std::string& file,
                               int count, unsigned seed, Damage damage, Reads reads) {
  EXPECT_GT(count, 0);
  const std::string whole = content_of(file);
  std::mt19937_64 random(seed);
  ReadCounts counts;
  for (int i = 0; i < count; ++i) {
    std::string content = whole;
    damage(content, random);
    const bool is_read = reads(with_header(format, content));
    ++(is_read ? counts.read : counts.refused);
    if (testing::Test::HasFatalFailure()) break;
  }
  return counts;
}

}  // namespace flinch::tests
