// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

#include "train/simulate/simulate.h"

namespace flinch::program {

/// Shows the progress of a simulation: on a terminal a bar with rate, time left and hit rate,
/// otherwise a line from time to time, both on stderr; or lines of JSON on stdout.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool json);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const train::SimulationProgress& progress);

 private:
  /// Figures that are shown with the progress.
  struct Rates {
    double scenarios_per_s = 0;
    double simulations_per_s = 0;
    double left_s = 0;
  };

  void begin(const train::SimulationProgress& progress);
  bool is_due(const train::SimulationProgress& progress);
  Rates rates(const train::SimulationProgress& progress) const;
  void show_json(const train::SimulationProgress& progress) const;
  void show_text(const train::SimulationProgress& progress);

  bool json_;
  bool terminal_;
  bool bar_shown_ = false;
  std::uint64_t tenth_shown_ = 0;
  bool started_ = false;
  std::uint64_t scenarios_at_start_ = 0;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace flinch::program
