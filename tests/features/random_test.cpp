// SPDX-License-Identifier: MIT
#include "features/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace flinch::features {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The known answers for philox4x32 with 10 rounds, published by Random123's authors (kat_vectors).
TEST(Philox, MatchesThePublishedTestVectors) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, StartsWithThePhiloxBlockOfItsSeedStreamAndSubstream) {
  const Words block = philox4x32({0, 0, 7, 1}, {3, 2});
  Random random((std::uint64_t{2} << 32) | 3, RandomStream::scenario, (std::uint64_t{1} << 32) | 7);
  EXPECT_EQ(random.bits(), block[0] | std::uint64_t{block[1]} << 32);
  EXPECT_EQ(random.bits(), block[2] | std::uint64_t{block[3]} << 32);
}

TEST(Random, SeedsStreamsAndSubstreamsAreIndependent) {
  std::set<std::uint64_t> first;
  for (std::uint64_t substream = 0; substream < 100; ++substream) {
    first.insert(Random(1, RandomStream::scenario, substream).bits());
    first.insert(Random(2, RandomStream::scenario, substream).bits());
    first.insert(Random(1, RandomStream::bootstrap, substream).bits());
  }
  EXPECT_EQ(first.size(), 300U);
}

TEST(Random, UniformStaysInItsRangeWithTheRightMeanAndVariance) {
  Random random(1, RandomStream::scenario, 0);
  constexpr int kCount = 100'000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.uniform();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kCount;
  EXPECT_NEAR(mean, 0.5, 0.004);  // 4 standard errors
  EXPECT_NEAR(squares / kCount - mean * mean, 1.0 / 12, 0.002);
}

TEST(Random, NormalHasTheMomentsAndTailsOfANormalDistribution) {
  Random random(1, RandomStream::perception, 0);
  constexpr int kCount = 100'000;
  std::array<double, 4> moments{};
  int beyond_two = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.normal();
    double power = 1;
    for (double& moment : moments) moment += (power *= value) / kCount;
    if (std::abs(value) > 2) ++beyond_two;
  }
  // Five standard errors for each moment: sqrt(1, 2, 15, 96) / sqrt(n).
  EXPECT_NEAR(moments[0], 0, 0.016);
  EXPECT_NEAR(moments[1], 1, 0.023);
  EXPECT_NEAR(moments[2], 0, 0.062);
  EXPECT_NEAR(moments[3], 3, 0.155);
  EXPECT_NEAR(beyond_two, 4550, 330);  // 4.55 %
}

TEST(Random, IndexIsUniform) {
  Random random(1, RandomStream::scenario, 0);
  constexpr int kDraws = 70'000;
  std::vector<int> count(7);
  for (int i = 0; i < kDraws; ++i) ++count[random.index(7)];
  for (const int c : count) EXPECT_NEAR(c, kDraws / 7, 400);  // 4 standard deviations
}

TEST(Random, ShuffleGivesAllOrdersAlike) {
  Random random(1, RandomStream::fitting, 0);
  constexpr int kShuffles = 48'000;
  std::map<std::vector<int>, int> count;
  for (int i = 0; i < kShuffles; ++i) {
    std::vector<int> items{0, 1, 2, 3};
    random.shuffle(items);
    ++count[items];
  }
  EXPECT_EQ(count.size(), 24U);
  for (const auto& [order, c] : count) EXPECT_NEAR(c, kShuffles / 24, 175);  // 4 deviations
}

TEST(Random, ShufflePutsEachItemAnywhere) {
  Random random(2, RandomStream::fitting, 0);
  constexpr int kItems = 1001;
  constexpr int kShuffles = 400;
  std::vector<double> sum(kItems);
  std::vector<int> items(kItems);
  for (int i = 0; i < kShuffles; ++i) {
    std::iota(items.begin(), items.end(), 0);
    random.shuffle(items);
    for (std::size_t place = 0; place < items.size(); ++place) sum[place] += items[place];
    std::ranges::sort(items);
    for (int item = 0; item < kItems; ++item)
      ASSERT_EQ(items[static_cast<std::size_t>(item)], item);
  }
  // The mean item of each place, with a standard error of 289 / sqrt(400).
  for (const double s : sum) EXPECT_NEAR(s / kShuffles, 500, 72);
}

}  // namespace
}  // namespace flinch::features
