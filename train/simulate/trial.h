// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "database/library/library.h"
#include "runtime/response/prepared_library.h"
#include "sim/rehearsal/simulator.h"
#include "train/objective/observation.h"
#include "train/scenario/scenario_sampling.h"
#include "train/simulate/shared_response.h"

namespace flinch::train {

/// What is simulated: all that the observations depend on.
struct SimulationPlan {
  ScenarioDistribution distribution;
  sim::SimulationOptions options;
  double tail_s = 0.3;  ///< simulated after the predicted impact, for late and second hits
  std::uint64_t seed = 1;
  /// Whether each trial is simulated by itself, from perception on: the slow way that the fast one
  /// is measured by.
  bool unabridged = false;
};

/// A library made ready for a plan: what is the same in every scenario. Refers to the library,
/// which must outlive it and stay where it is.
struct SimulationSetup {
  SimulationSetup(const database::ClipLibrary& simulated, const SimulationPlan& planned);
  SimulationSetup(const SimulationSetup&) = delete;
  SimulationSetup& operator=(const SimulationSetup&) = delete;

  const motion::Motion& idle() const { return prepared.idle(); }

  const database::ClipLibrary& library;
  runtime::PreparedLibrary prepared;
  SimulationPlan plan;
  motion::BodyModel body_model;
  sim::Simulator simulator;
  SharedResponses responses;
};

/// Scenario `number` with its features, before any trial.
Observation make_observation(const SimulationSetup& setup, std::uint64_t number);

/// The clips that are tried on a threat at this target: the allowed and the idle one, by rising
/// index.
std::vector<int> clips_to_try(const database::ClipLibrary& library, motion::Target threatened);

/// A trial with what its simulation found.
struct TrialResult {
  Trial trial;
  sim::SimulationResult simulated;
};

/// Simulates the response with one clip, from perception to the plan's tail after the predicted
/// impact, and takes the work of the whole response.
TrialResult try_unabridged(const SimulationSetup& setup, const features::Scenario& scenario,
                           int clip);
/// The trial alone.
Trial try_clip(const SimulationSetup& setup, const features::Scenario& scenario, int clip);

/// A response that any threat may be tried on.
struct RehearsedResponse {
  ResponseKey key;
  sim::Rehearsal rehearsal;
  float work_j = 0;  ///< of the whole response

  std::size_t byte_count() const { return sizeof *this + rehearsal.byte_count(); }
};

RehearsedResponse rehearse(const SimulationSetup& setup, const ResponseKey& key);

/// The trial of a scenario whose response with `response.key.clip` is the same as this from the
/// impact. The threat is met where it is by the time that the rehearsed response begins.
TrialResult try_rehearsed(const SimulationSetup& setup, const features::Scenario& scenario,
                          const RehearsedResponse& response);

/// Work of a clip's response as it is when there is all the time in the world, J: begun at once
/// from the idle clip's start, played at its own rate. 0 for the idle clip.
double reference_work_j(const SimulationSetup& setup, int clip);

}  // namespace flinch::train
