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

/// What the store of this plan says of itself. Throws Error if no clip of the library is annotated
/// or the library breaks its invariants.
StoreHeader make_store_header(const SimulationSetup& setup);

/// What a run may use, bytes.
struct MemoryPlan {
  std::uint64_t max_bytes = std::uint64_t{1} << 30;  ///< the whole process
  std::uint64_t reserved_bytes = 0;                  ///< of it for all but rehearsed responses
  std::uint64_t all_response_bytes = 0;              ///< what keeping all of them would take, about
  std::size_t response_count = 0;

  std::uint64_t response_bytes() const { return max_bytes - reserved_bytes; }
  bool keeps_all() const { return all_response_bytes <= response_bytes(); }
};

/// Throws Error, with the least that does, for `max_bytes` bytes that are too few for the program
/// alone.
MemoryPlan plan_memory(const SimulationSetup& setup, std::uint64_t max_bytes, int threads);

/// How a simulation stands.
struct SimulationProgress {
  std::uint64_t scenarios = 0;  ///< of those wanted, in the store
  std::uint64_t wanted = 0;     ///< wanted
  SimulationCounts counts;      ///< of this run
  PhaseTimes cpu;               ///< of this run, all its processes
};

/// What a run is asked for and given to work with.
struct SimulationRun {
  ScenarioRange wanted;
  MemoryPlan memory;
  BatchContext batch;              ///< but for what to attend to
  Messenger* messenger = nullptr;  ///< to the other processes, if there are any
  /// Called after every commit, from the calling thread; of the writer only.
  std::function<void(const SimulationProgress&)> report = [](const SimulationProgress&) {};
};

/// Fills the store at `path` with the wanted scenarios, going on from what is there: with the
/// workers, if there are any, as the run's process 0. Returns false when `stop` became true first:
/// what was finished by then is kept and the next call goes on. The store's bytes do not depend on
/// threads, memory, processes or interruptions.
bool simulate_store(const SimulationSetup& setup, const std::string& path,
                    const SimulationRun& run);

/// Simulates what process 0 of the run asks for until it wants nothing any more: for the run's
/// other processes.
void run_simulation_worker(const SimulationSetup& setup, const SimulationRun& run);

}  // namespace flinch::train
