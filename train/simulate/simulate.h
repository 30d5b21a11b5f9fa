// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "train/simulate/batch.h"
#include "train/simulate/messenger.h"
#include "train/simulate/trial.h"
#include "train/store/store.h"

namespace flinch::train {

/// Returns the distribution as JSON text, with the keys of its file; stores keep it.
std::string describe(const ScenarioDistribution& distribution);

/// Returns the header of this plan's store. Throws Error if no clip of the library is annotated or
/// the library breaks its invariants.
StoreHeader make_store_header(const SimulationSetup& setup);

/// How a run divides its memory between rehearsed responses and the scenarios of a batch.
struct MemoryPlan {
  std::uint64_t max_bytes = std::uint64_t{1} << 30;  ///< of the whole process
  std::uint64_t all_response_bytes = 0;  ///< approximate size of all rehearsed responses
  std::size_t response_count = 0;
  std::uint64_t response_bytes = std::uint64_t{1} << 30;  ///< for those that are kept
  std::uint64_t batch_size = 128;                         ///< scenarios per thread

  bool keeps_all() const { return all_response_bytes <= response_bytes; }
};

/// Throws Error, with the minimum that is enough, if `max_bytes` bytes are too few for the program
/// alone.
MemoryPlan plan_memory(const SimulationSetup& setup, std::uint64_t max_bytes, int threads);

/// Progress of a simulation.
struct SimulationProgress {
  std::uint64_t scenarios = 0;  ///< wanted scenarios that are in the store
  std::uint64_t wanted = 0;     ///< wanted
  SimulationCounts counts;      ///< of this run
  PhaseTimes cpu;               ///< of this run, all its processes
};

/// Inputs and resources of a run.
struct SimulationRun {
  ScenarioRange wanted;
  MemoryPlan memory;
  BatchContext batch;              ///< without what the run itself polls
  Messenger* messenger = nullptr;  ///< to the other processes, or null
  /// Whether a file at the store's path that is no store is replaced.
  database::Overwrite overwrite = database::Overwrite::refuse;
  /// Called after every commit, on the calling thread of the process that writes.
  std::function<void(const SimulationProgress&)> report = [](const SimulationProgress&) {};
};

/// Fills the store at `path` with the wanted scenarios and continues what is there. Acts as process
/// 0 of the run and uses the workers, if there are any. Returns false if `stop` became true first;
/// the next call then continues from what was finished. The store's bytes do not depend on threads,
/// memory, processes or interruptions.
bool simulate_store(const SimulationSetup& setup, const std::string& path,
                    const SimulationRun& run);

/// Simulates the ranges that process 0 of the run assigns, until there are none. For the run's
/// other processes.
void run_simulation_worker(const SimulationSetup& setup, const SimulationRun& run);

}  // namespace flinch::train
