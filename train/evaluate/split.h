// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/store/store.h"

namespace flinch::train {

/// Whether a scenario is kept out of fitting where there is no other store to test on: every
/// fourth, by its number.
constexpr bool is_held_out(std::uint64_t number) {
  return number % 4 == 3;
}

/// What selectors are fitted to, and what they are tried on.
struct TrainTestSplit {
  StoreHeader header;  ///< of the store that is fitted to
  std::vector<Observation> fitted;
  std::vector<Observation> tested;
  bool has_test_store = false;  ///< otherwise the tested ones were held out
};

/// Throws Error unless both stores are of one library and one simulation, have features in one
/// layout, and share no scenario: none with the same number, seed and distribution. `path` holds
/// `test`.
void require_independent(const Store& training, const Store& test, const std::string& path);

/// Every fourth scenario is held out. Throws Error when fewer than two are.
TrainTestSplit split_of(Store store);

/// Fits to one store and tests on another, which require_independent() lets pass. Throws Error when
/// either has fewer than two scenarios.
TrainTestSplit split_of(Store training, Store test);

}  // namespace flinch::train
