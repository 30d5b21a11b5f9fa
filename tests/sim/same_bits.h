// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <thread>
#include <vector>

#include "sim/simulation_result.h"

namespace flinch::scenes {

inline void expect_same_bits(const sim::SimulationResult& first,
                             const sim::SimulationResult& second) {
  EXPECT_EQ(std::memcmp(&first.impulse, &second.impulse, sizeof first.impulse), 0);
  EXPECT_EQ(first.first_contact_s, second.first_contact_s);
  EXPECT_EQ(first.tracking_error_m, second.tracking_error_m);
  EXPECT_EQ(first.steps, second.steps);
  EXPECT_EQ(first.is_finite, second.is_finite);
}

/// Expects that `run`, which appends its results, gives the same bits on one thread alone as on
/// three at the same time.
template <class Run>
void expect_same_bits_on_threads(const Run& run) {
  std::vector<sim::SimulationResult> alone;
  run(alone);
  std::array<std::vector<sim::SimulationResult>, 3> together;
  std::vector<std::thread> threads;
  for (auto& results : together) threads.emplace_back([&] { run(results); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& results : together) {
    ASSERT_EQ(results.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i) expect_same_bits(alone[i], results[i]);
  }
}

}  // namespace flinch::scenes
