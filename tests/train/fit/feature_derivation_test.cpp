// SPDX-License-Identifier: MIT
#include "train/fit/feature_derivation.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "runtime/character.h"
#include "runtime/library.h"
#include "runtime/response/prepared_library.h"
#include "tests/train/evaluate/comparison.h"
#include "train/fit/selector_writer.h"

namespace flinch::train {
namespace {

// The features that a character in a game computes for a scenario and those that its selector was
// trained on have the same bits, for every layout, so it chooses what the trainer would choose.
TEST(FeatureDerivation, MatchesTheRunTimeBitForBit) {
  for (const features::FeatureSet& set : features::feature_sets()) {
    Store store = made_up_store(60);
    derive_features(set.layout, store);
    const Training training = train_selector(store.header, store.observations,
                                             default_cost(store.header), Method::knn, 1);
    const std::string bytes = selector_bytes(training.selector, store.header.library_file);
    runtime::Library library;
    ASSERT_EQ(library.load(std::as_bytes(std::span(bytes))), database::LoadStatus::ok);
    EXPECT_EQ(library.selector().layout, set.layout);
    runtime::Workspace workspace;
    workspace.reserve_memory(library.selection_bytes());
    for (const Observation& observation : store.observations) {
      const features::Scenario& scenario = observation.scenario;
      EXPECT_EQ(features::feature_vector(library.selector().layout, scenario,
                                         library.prepared().figure_in(scenario.state)),
                observation.features)
          << set.name;
      runtime::Character character(library);
      character.place(scenario.state.position, scenario.state.facing, scenario.state.idle_time_s);
      ASSERT_EQ(character.perceive(scenario.threat, scenario.target, scenario.time_to_impact_s,
                                   workspace),
                runtime::Status::ok);
      EXPECT_EQ(character.candidates()[0].clip,
                models::select(training.selector, observation.features, scenario.target));
    }
  }
}

TEST(FeatureDerivation, OfThePapersFeaturesChangesNothing) {
  const Store before = made_up_store(20);
  Store after = before;
  derive_features(features::feature_set_named("paper")->layout, after);
  for (std::size_t i = 0; i < before.observations.size(); ++i)
    EXPECT_EQ(after.observations[i].features, before.observations[i].features);
}

TEST(FeatureDerivation, RejectsADamagedLibrary) {
  Store store = made_up_store(2);
  store.header.library_file.resize(100);
  EXPECT_THROW(derive_features(features::feature_set_named("geometry")->layout, store), Error);
}

}  // namespace
}  // namespace flinch::train
