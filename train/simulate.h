// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "database/library.h"
#include "runtime/prepared_library.h"
#include "sim/simulator.h"
#include "train/observation.h"
#include "train/scenario_sampling.h"
#include "train/store.h"

namespace flinch::train {

/// What is simulated: all that the observations depend on.
struct SimulationPlan {
  ScenarioDistribution distribution;
  sim::SimulationOptions options;
  double tail_s = 0.3;  ///< simulated after the predicted impact, for late and second hits
  std::uint64_t seed = 1;
};

/// A library made ready for a plan: what is the same in every scenario. Refers to the library,
/// which must outlive it.
struct SimulationSubject {
  SimulationSubject(const database::Library& simulated, const SimulationPlan& planned);

  const database::Library& library;
  runtime::PreparedLibrary prepared;
  SimulationPlan plan;
  motion::BodyModel body_model;
  sim::Simulator simulator;
};

/// Scenario `number` with its features, before any trial.
Observation pose_scenario(const SimulationSubject& subject, std::uint64_t number);

/// The clips that are tried on a threat at this target: the allowed and the idle one, by rising
/// index.
std::vector<int> clips_to_try(const database::Library& library, motion::Target threatened);

/// Simulates the response with one clip, from perception to the plan's tail after the predicted
/// impact, and takes the work of the whole response.
Trial try_clip(const SimulationSubject& subject, const features::Scenario& scenario, int clip);

/// Work of a clip's response as it is when there is all the time in the world, J: begun at once
/// from the idle clip's start, played at its own rate. 0 for the idle clip.
double reference_work_j(const SimulationSubject& subject, int clip);

/// What the store of this plan says of itself. Throws Error if no clip of the library is annotated
/// or the library breaks its invariants.
StoreHeader make_store_header(const SimulationSubject& subject);

/// Simulates scenarios first, first + 1, …, one a slot of `observations`, on `threads` threads. The
/// result does not depend on how many. Returns false, with `observations` unusable, when `stop`
/// became true meanwhile. What a thread throws is thrown here.
bool simulate_batch(const SimulationSubject& subject, int threads, std::uint64_t first,
                    std::vector<Observation>& observations, const std::atomic<bool>& stop);

/// How a simulation stands.
struct SimulationProgress {
  std::uint64_t scenarios = 0;    ///< in the store
  std::uint64_t of = 0;           ///< wanted
  std::uint64_t simulations = 0;  ///< by this run
};

/// Fills the store at `path` up to `scenarios` scenarios, going on from what is there. Returns
/// false when `stop` became true first: what was finished by then is kept and the next call goes
/// on. `report` is called after each batch, from this thread.
bool simulate_store(const SimulationSubject& subject, const std::string& path,
                    std::uint64_t scenarios, int threads, const std::atomic<bool>& stop,
                    const std::function<void(const SimulationProgress&)>& report);

}  // namespace flinch::train
