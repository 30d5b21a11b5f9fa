// SPDX-License-Identifier: MIT
#include "evolve/label/pain_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/error_of.h"
#include "tests/train/store/made_up_store.h"
#include "train/fit/labels.h"
#include "train/simulate/simulate.h"

namespace flinch::evolve {
namespace {

using motion::Body;
using testing::HasSubstr;

train::Store simulated_store(bool keeps_places) {
  const database::ClipLibrary library = scenes::synthetic_library();
  train::SimulationPlan plan;
  plan.options.keeps_places = keeps_places;
  const train::SimulationSetup setup(library, plan);
  train::RehearsalCache rehearsals(std::uint64_t{1} << 30);
  train::Batch batch;
  EXPECT_TRUE(simulate_batch(setup, rehearsals, {0, 20}, {}, batch));
  return {make_store_header(setup), batch.observations};
}

train::Labels labels_of(const train::Store& store, const train::VulnerabilityProfile& profile) {
  return label(store.observations, make_cost_model(store.header, profile, 0));
}

TEST(PainLabels, CountABodyByItsWorstRegion) {
  const auto profile = largest_pain(thesis_pain(), "pain");
  EXPECT_EQ(profile.name, "pain");
  EXPECT_DOUBLE_EQ(profile.vulnerability[Body::head], 1);  // of the eyes, 15
  EXPECT_DOUBLE_EQ(profile.vulnerability[Body::neck], 5.0 / 15);
  EXPECT_DOUBLE_EQ(profile.vulnerability[Body::left_forearm], 3.0 / 15);
  EXPECT_DOUBLE_EQ(profile.vulnerability[Body::right_hand], 1.0 / 15);
  PainMap map = thesis_pain();
  map.multiplier[PainRegion::back_of_hand] = 30;
  EXPECT_DOUBLE_EQ(largest_pain(map, "pain").vulnerability[Body::left_hand], 1);
  EXPECT_DOUBLE_EQ(largest_pain(map, "pain").vulnerability[Body::head], 0.5);
}

// Equation 4.2 from the simulation's own places, which the store has not rounded or joined.
TEST(PainLabels, AreThePainOfTheSimulatedHits) {
  const database::ClipLibrary library = scenes::synthetic_library();
  train::SimulationPlan plan;
  plan.options.keeps_places = true;
  const train::SimulationSetup setup(library, plan);
  train::Store store = simulated_store(true);
  relabel_by_pain(thesis_pain(), store, "store");
  const train::Labels labels = labels_of(store, largest_pain(thesis_pain(), "pain"));
  sim::ThrowSimulator throws(setup.simulator);
  int hurt = 0;
  int close = 0;
  for (std::size_t i = 0; i < store.observations.size(); ++i) {
    const train::Observation& observation = store.observations[i];
    const auto cell = grid_cell_of(plan.distribution, setup.stances, observation.scenario);
    for (std::size_t t = 0; t < observation.trials.size(); ++t) {
      const auto response =
          rehearse(setup, setup.responses.key_of(observation.trials[t].clip, cell));
      const std::vector<train::RehearsedTrial> trial{{observation.scenario, response}};
      const auto result = try_rehearsed(setup, trial, throws).front();
      const double pain = pain_of(thesis_pain(), setup.body_model, result.simulated.places) / 15;
      hurt += pain > 0.1 ? 1 : 0;
      if (pain > 0.1) close += std::abs(labels.cost[i][t] / pain - 1) < 1e-4 ? 1 : 0;
    }
  }
  EXPECT_GT(hurt, 40);
  // A place within a millimetre of a region's border may change sides.
  EXPECT_GE(close, hurt - hurt / 20);
}

TEST(PainLabels, OfAMapWithoutDifferencesAreThoseOfUniformVulnerability) {
  train::Store store = simulated_store(true);
  const train::Labels uniform = labels_of(store, *train::vulnerability_profile_named("uniform"));
  PainMap map;
  for (double& multiplier : map.multiplier) multiplier = 7;
  relabel_by_pain(map, store, "store");
  const train::Labels labels = labels_of(store, largest_pain(map, "pain"));
  EXPECT_EQ(labels.clip, uniform.clip);
  for (std::size_t i = 0; i < labels.cost.size(); ++i)
    for (std::size_t t = 0; t < labels.cost[i].size(); ++t)
      EXPECT_NEAR(labels.cost[i][t], uniform.cost[i][t], 1e-5 + 1e-5 * uniform.cost[i][t]);
}

TEST(PainLabels, NeedAStoreThatKeepsPlaces) {
  train::Store store = simulated_store(false);
  EXPECT_THAT(tests::error_of([&] { relabel_by_pain(thesis_pain(), store, "a.flinchobs"); }),
              HasSubstr("a.flinchobs: keeps no places of hits, which --pain needs; simulate it "
                        "again with --places"));
}

}  // namespace
}  // namespace flinch::evolve
