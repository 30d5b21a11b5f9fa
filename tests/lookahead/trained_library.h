// SPDX-License-Identifier: MIT
#pragma once

#include "lookahead/look_ahead.h"
#include "tests/scenes/guard.h"
#include "tests/scenes/synthetic_library.h"
#include "train/fit/labels.h"
#include "train/fit/selector_writer.h"
#include "train/fit/training.h"
#include "train/simulate/simulate.h"

namespace flinch::tests {

/// A library with a selector that was trained on it in the trainer's way, and the plan of that.
struct TrainedLibrary {
  database::ClipLibrary clips;
  train::SimulationSetup setup;
  std::vector<train::Observation> observations;
  runtime::Library library;
  std::shared_ptr<const lookahead::LookAheadData> data;

  explicit TrainedLibrary(std::uint64_t scenarios, double brawn = 0.5,
                          database::ClipLibrary trained = scenes::synthetic_library(),
                          const train::SimulationPlan& plan = {})
      : clips(std::move(trained)), setup(clips, plan), observations(simulated({0, scenarios})) {
    const train::StoreHeader header = make_store_header(setup);
    const train::CostModel model =
        make_cost_model(header, train::vulnerability_profiles()[0], brawn);
    const train::Training training =
        train_selector(header, observations, model, train::Method::knn_cost, 1);
    const std::string file =
        train::selector_bytes(training.selector, std::as_bytes(std::span(header.library_file)));
    library.load(std::as_bytes(std::span(file)));
    data = lookahead::make_look_ahead_data(library);
  }

  /// Scenarios by number, with all of their trials.
  std::vector<train::Observation> simulated(const train::ScenarioRange& range) const {
    train::RehearsalCache rehearsals(std::uint64_t{1} << 28);
    train::Batch batch;
    simulate_batch(setup, rehearsals, range, {}, batch);
    return std::move(batch.observations);
  }

  const models::ResponseCosts& costs() const { return *library.selector().costs; }
  lookahead::LookAheadWorkspace workspace() const {
    lookahead::LookAheadWorkspace made;
    made.reserve_memory(library, data);
    return made;
  }
};

/// The same for all tests of a program.
inline const TrainedLibrary& trained() {
  static const TrainedLibrary kTrained(80);
  return kTrained;
}

/// The same with a second stance, a guard, in which half of the scenarios begin.
inline const TrainedLibrary& trained_with_guard() {
  train::SimulationPlan plan;
  plan.distribution.stances = {{0, "idle", 1}, {1, "guard", 1}};
  static const TrainedLibrary kTrained(400, 0.2, with_guard(scenes::synthetic_library()), plan);
  return kTrained;
}

/// A character at the origin in the state of an observation's scenario.
inline runtime::Character character_of(const TrainedLibrary& trained,
                                       const features::Scenario& scenario) {
  runtime::Character character(trained.library);
  character.place(scenario.state.position, scenario.state.facing, scenario.state.idle_time_s,
                  scenario.state.stance);
  return character;
}

}  // namespace flinch::tests
