// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <ctime>

#include "tests/scenes/allocation_count.h"
#include "tests/scenes/sample_count.h"

namespace flinch::tests {

/// Measures what this thread allocates and computes from its construction on. For tests that link
/// flinch_test_allocation_count.
class ReadCost {
 public:
  /// Fails if more than 1 s of the processor was used, or more memory than `most_bytes`.
  void expect_below(std::size_t most_bytes) const {
    EXPECT_LE(allocated_bytes() - bytes_, most_bytes);
    const double seconds = static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, draws_fewer_samples() ? 20 : 1);  // sanitizers take ten times as long
  }

  /// What reading a file of this size may take, whatever it holds.
  static std::size_t allowance(std::size_t file_size) { return 4 * file_size + (64U << 20); }

 private:
  std::size_t bytes_ = allocated_bytes();
  std::clock_t begin_ = std::clock();
};

}  // namespace flinch::tests
