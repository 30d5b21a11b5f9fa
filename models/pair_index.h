// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace flinch::models {

/// Index of the pair of classes i < j, of `count` classes, in the order (0,1), (0,2), …, (1,2), ….
constexpr std::size_t pair_index(std::size_t i, std::size_t j, std::size_t count) {
  return i * count - i * (i + 1) / 2 + (j - i - 1);
}

/// All pairs of `count` classes, in that order.
inline std::vector<std::pair<std::size_t, std::size_t>> class_pairs(std::size_t count) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) pairs.emplace_back(i, j);
  }
  return pairs;
}

}  // namespace flinch::models
