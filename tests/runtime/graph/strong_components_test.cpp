// SPDX-License-Identifier: MIT
#include "runtime/graph/strong_components.h"

#include <gtest/gtest.h>

#include <random>

namespace flinch::runtime {
namespace {

/// Which nodes can be reached from which, by trying all ways over each node in turn.
std::vector<std::vector<bool>> reachability(const Successors& successors) {
  const std::size_t count = successors.size();
  std::vector<std::vector<bool>> reaches(count, std::vector<bool>(count));
  for (std::size_t i = 0; i < count; ++i) {
    reaches[i][i] = true;
    for (const std::uint32_t j : successors[i]) reaches[i][j] = true;
  }
  for (std::size_t over = 0; over < count; ++over) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j)
        reaches[i][j] = reaches[i][j] || (reaches[i][over] && reaches[over][j]);
    }
  }
  return reaches;
}

TEST(StrongComponents, HoldTheNodesThatReachEachOther) {
  std::mt19937 random(1);
  std::size_t components = 0;
  for (std::size_t count = 1; count <= 40; ++count) {
    std::uniform_int_distribution<std::size_t> any(0, count - 1);
    Successors successors(count);
    const std::size_t edges = count + any(random) / 2;
    for (std::size_t k = 0; k < edges; ++k) {
      const std::size_t from = any(random);
      successors[from].push_back(static_cast<std::uint32_t>(any(random)));
    }
    const auto reaches = reachability(successors);
    const std::vector<std::uint32_t> of = strong_components(successors);
    std::size_t largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t size = 0;
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(of[i] == of[j], reaches[i][j] && reaches[j][i]) << count << ' ' << i << ' ' << j;
        EXPECT_TRUE(!reaches[i][j] || of[i] >= of[j]);
        size += of[i] == of[j] ? 1 : 0;
      }
      largest = std::max(largest, size);
    }
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(of, largest_component(of))), largest);
    components += std::ranges::max(of) + std::size_t{1};
  }
  EXPECT_GT(components, 100U);
}

TEST(StrongComponents, OfAMillionNodesInARowNeedNoStack) {
  Successors successors(1'000'000);
  for (std::uint32_t i = 0; i + 1 < successors.size(); ++i) successors[i] = {i + 1};
  EXPECT_EQ(largest_component(strong_components(successors)), 0U);
  successors.back() = {0};
  const auto of = strong_components(successors);
  EXPECT_EQ(std::ranges::count(of, 0U), 1'000'000);
}

}  // namespace
}  // namespace flinch::runtime
