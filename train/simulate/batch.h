// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "train/simulate/rehearsal_cache.h"
#include "train/store/scenario_range.h"

namespace flinch::train {

/// What simulations did, counted; the same for the same scenarios.
struct SimulationCounts {
  std::uint64_t simulations = 0;
  std::uint64_t skipped = 0;  ///< of them, because nothing could touch
  std::uint64_t hits = 0;     ///< of them, with contact of ball and figure
  std::uint64_t steps = 0;
  std::uint64_t solver_messages = 0;

  void add(const sim::SimulationResult& result);
  void add(const SimulationCounts& other);
};

/// CPU time by what it went into, all threads', s.
struct PhaseTimes {
  double posing_s = 0;      ///< drawing scenarios
  double rehearsing_s = 0;  ///< simulating responses without a ball, and taking their work
  double contact_s = 0;     ///< simulating what the ball does; unabridged, all of a simulation
  double writing_s = 0;     ///< into the store

  void add(const PhaseTimes& other);
  double total_s() const;
};

/// CPU time of the calling thread since any fixed moment, s.
using CpuClock = std::function<double()>;

/// What a batch needs from outside.
struct BatchContext {
  int threads = 1;
  CpuClock cpu_s = [] { return 0.0; };
  const std::atomic<bool>* stop = nullptr;  ///< when it becomes true the batch is given up
  /// Called on the calling thread now and then while it works: after each response's trials.
  std::function<void()> poll = [] {};
};

/// Scenarios that were simulated together.
struct Batch {
  std::vector<Observation> observations;  ///< by rising number
  SimulationCounts counts;
  PhaseTimes cpu;
};

/// Simulates the scenarios of a range: every trial of one response after the other, so that what
/// was rehearsed stays in the processor's cache, and the responses shared out among the threads.
/// The observations do not depend on how many threads there are, what is kept in `rehearsals`, or
/// which scenarios are simulated together. Returns false, with `batch` unusable, when `stop` became
/// true meanwhile. What a thread throws is thrown here.
bool simulate_batch(const SimulationSetup& setup, RehearsalCache& rehearsals, ScenarioRange range,
                    const BatchContext& context, Batch& batch);

}  // namespace flinch::train
