// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "database/library/library.h"
#include "runtime/response/prepared_library.h"
#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "sim/rehearsal/throw_simulator.h"
#include "train/objective/observation.h"
#include "train/scenario/scenario_sampling.h"
#include "train/scenario/threat_file.h"
#include "train/simulate/shared_response.h"

namespace flinch::train {

/// Everything that the observations depend on.
struct SimulationPlan {
  ScenarioDistribution distribution;
  /// Name or file that the distribution is from; for the provenance alone.
  std::string threats{threat_files().front().name};
  sim::SimulationOptions options;
  double tail_s = 0.3;  ///< simulated time after the predicted impact, for late and second hits
  std::uint64_t seed = 1;
  /// Whether to simulate each trial separately, from perception on. This is the slow reference that
  /// the fast method is compared with.
  bool unabridged = false;
};

/// A library prepared for a plan: everything that is the same in all scenarios. Refers to the
/// library, which must outlive it and stay in place.
struct SimulationSetup {
  SimulationSetup(const database::ClipLibrary& simulated, const SimulationPlan& planned);
  SimulationSetup(const SimulationSetup&) = delete;
  SimulationSetup& operator=(const SimulationSetup&) = delete;

  const database::ClipLibrary& library;
  runtime::PreparedLibrary prepared;
  std::vector<motion::Loop> stances;  ///< of the library
  SimulationPlan plan;
  motion::BodyModel body_model;
  sim::Simulator simulator;
  sim::OdeSimulator reference_simulator;  ///< for unabridged simulations
  SharedResponses responses;
};

/// Returns scenario `number` with its features, without trials.
Observation make_observation(const SimulationSetup& setup, std::uint64_t number);

/// A trial and the result of its simulation.
struct TrialResult {
  Trial trial;
  std::vector<HitPlace> places;  ///< empty unless the plan keeps them
  sim::SimulationResult simulated;
};

/// Simulates the response with one clip, from perception to the plan's tail after the predicted
/// impact, and computes the work of the whole response.
TrialResult try_unabridged(const SimulationSetup& setup, const features::Scenario& scenario,
                           int clip);
/// Returns only the trial of try_unabridged().
Trial try_clip(const SimulationSetup& setup, const features::Scenario& scenario, int clip);

/// A rehearsed response, on which any threat can be tried.
struct RehearsedResponse {
  ResponseKey key;
  sim::Rehearsal rehearsal;
  float work_j = 0;  ///< of the whole response

  std::size_t byte_count() const { return sizeof *this + rehearsal.byte_count(); }
};

RehearsedResponse rehearse(const SimulationSetup& setup, const ResponseKey& key);

/// A scenario, and its response with one clip or, the same relative to the impact, one to a shorter
/// time.
struct RehearsedTrial {
  const features::Scenario& scenario;
  const RehearsedResponse& response;
};

/// Returns the trial of each scenario with its response, the same whatever the other trials are.
/// The threat starts from where it is when the rehearsed response starts. `throws` is that of
/// `setup.simulator`. Throws Error where a simulation's numbers are not finite.
std::vector<TrialResult> try_rehearsed(const SimulationSetup& setup,
                                       std::span<const RehearsedTrial> trials,
                                       sim::ThrowSimulator& throws);

/// Returns the work of a clip's response with unlimited time, J: started at once from the idle
/// clip's start and played at its own rate. 0 for the idle clip.
double reference_work_j(const SimulationSetup& setup, int clip);

}  // namespace flinch::train
