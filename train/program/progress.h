// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

#include "train/simulate.h"

namespace flinch::train::program {

/// Shows how a simulation goes on, on stderr: a bar with rate and time left on a terminal, a line
/// every tenth of the way otherwise.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool quiet);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const SimulationProgress& progress);

 private:
  void show_line(const SimulationProgress& progress);

  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  std::uint64_t tenth_shown_ = 0;
  bool started_ = false;
  std::uint64_t scenarios_at_start_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace flinch::train::program
