// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "train/simulate/rehearsal_cache.h"
#include "train/store/scenario_range.h"

namespace flinch::train {

/// Counts of simulations; the same for the same scenarios.
struct SimulationCounts {
  std::uint64_t simulations = 0;
  std::uint64_t skipped = 0;  ///< trials without a simulation, because nothing could touch
  std::uint64_t hits = 0;     ///< trials with a contact of ball and figure
  std::uint64_t steps = 0;
  std::uint64_t solver_messages = 0;

  void add(const sim::SimulationResult& result);
  void add(const SimulationCounts& other);
};

/// CPU time of all threads, by phase, s.
struct PhaseTimes {
  double posing_s = 0;      ///< drawing scenarios
  double rehearsing_s = 0;  ///< simulating responses without a ball, and computing their work
  double contact_s = 0;     ///< simulating the ball; if unabridged, the whole simulation
  double writing_s = 0;     ///< writing into the store

  void add(const PhaseTimes& other);
  double total_s() const;
};

/// CPU time of the calling thread since any fixed moment, s.
using CpuClock = std::function<double()>;

/// Resources that the caller provides for a batch.
struct BatchContext {
  int threads = 1;
  /// Simulations that each thread steps side by side: see sim::ThrowSimulator.
  std::size_t lanes = sim::widest_lanes();
  CpuClock cpu_s = [] { return 0.0; };
  const std::atomic<bool>* stop = nullptr;  ///< the batch stops when this becomes true
  /// Called on the calling thread from time to time while it works: after each response's trials.
  std::function<void()> poll = [] {};
};

/// Scenarios that were simulated together.
struct Batch {
  std::vector<Observation> observations;  ///< in ascending order of their number
  SimulationCounts counts;
  PhaseTimes cpu;
};

/// Memory that a trial of a batch takes, bytes: the trial, and twice, while they are sorted, what
/// tells the response that it shares.
inline constexpr std::size_t kBatchBytesPerTrial = 144;
/// Memory that the places of a trial take beside it, bytes: their vector, and twice, while they are
/// gathered, those of two hits.
inline constexpr std::size_t kBatchBytesOfPlaces = 24 + 4 * sizeof(HitPlace);

/// Simulates the scenarios of a range. Runs all trials of one response in a row, so that its
/// rehearsal stays in the processor's cache, and distributes the responses over the threads. The
/// observations do not depend on the number of threads, on what `rehearsals` holds, or on which
/// scenarios are simulated together. Returns false, and leaves `batch` unusable, if `stop` became
/// true. Rethrows the first exception of a thread.
bool simulate_batch(const SimulationSetup& setup, RehearsalCache& rehearsals, ScenarioRange range,
                    const BatchContext& context, Batch& batch);

}  // namespace flinch::train
