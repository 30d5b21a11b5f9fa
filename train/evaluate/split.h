// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/store/store.h"

namespace flinch::train {

/// Whether a scenario is held out of the fit when there is no test store: every fourth, by its
/// number.
constexpr bool is_held_out(std::uint64_t number) {
  return number % 4 == 3;
}

/// The observations that selectors are fitted to, and those that they are tested on.
struct TrainTestSplit {
  StoreHeader header;  ///< of the training store
  std::vector<Observation> fitted;
  std::vector<Observation> tested;
  /// If false, the test scenarios were held out of the training store.
  bool has_test_store = false;
  StoreHeader test_header;  ///< of the store that the test scenarios are from
};

/// Throws Error unless both stores are from the same library and simulation, have the same kinds of
/// threats and feature layout, and share no scenario, that is none with the same number, seed and
/// distribution. `path` is the file of `test`.
void require_independent(const Store& training, const Store& test, const std::string& path);

/// Holds out every fourth scenario. Throws Error if those are fewer than two.
TrainTestSplit split_of(Store store);

/// Fits to one store and tests on another; the two must pass require_independent(). Throws Error if
/// either has fewer than two scenarios.
TrainTestSplit split_of(Store training, Store test);

}  // namespace flinch::train
