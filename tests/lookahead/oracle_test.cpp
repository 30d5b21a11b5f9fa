// SPDX-License-Identifier: MIT
#include "lookahead/oracle/oracle.h"

#include <gtest/gtest.h>

#include "tests/lookahead/trained_library.h"
#include "train/objective/cost.h"

namespace flinch::lookahead {
namespace {

using tests::trained;

/// What a character knows of an observation's scenario.
runtime::Perception perceived(const features::Scenario& scenario) {
  return {scenario, 0};
}

TEST(Oracle, MeasuresWhatTrainingMeasuresAndChoosesItsLabel) {
  const Oracle oracle(trained().library);
  const train::CostModel model = train::make_cost_model(make_store_header(trained().setup),
                                                        train::vulnerability_profiles()[0], 0.5);
  for (std::size_t i = 0; i < 12; ++i) {
    const train::Observation& observation = trained().observations[i];
    const runtime::Character character = tests::character_of(trained(), observation.scenario);
    const std::vector<ClipTrial> trials =
        oracle.try_all(character, perceived(observation.scenario), observation.scenario.threat);
    ASSERT_EQ(trials.size(), observation.trials.size());
    for (std::size_t k = 0; k < trials.size(); ++k) {
      const train::Trial& expected = observation.trials[k];
      EXPECT_EQ(trials[k].clip, expected.clip);
      // Training shares the response of other times to impact, which is the same but for rounding.
      const double cost_ns = train::cost_of(expected, 0, model);
      EXPECT_NEAR(trials[k].cost_ns, cost_ns, 1e-3 * (1 + cost_ns)) << "scenario " << i;
      EXPECT_NEAR(trials[k].work_j, expected.work_j, 1e-3 * (1 + double{expected.work_j}));
    }
    const std::vector<double> costs = train::costs_of(observation.trials, 0, model);
    EXPECT_EQ(best_of(trials), train::best_trial(observation.trials, costs));
  }
}

TEST(Oracle, ThreatsThatTheCharacterMisjudgesAreSimulatedAsTheyAre) {
  const Oracle oracle(trained().library);
  const features::Scenario& scenario = trained().observations[0].scenario;
  const runtime::Character character = tests::character_of(trained(), scenario);
  features::Threat away = scenario.threat;
  away.velocity = -away.velocity;
  const auto trial = oracle.try_clip(character, perceived(scenario), away, trained().clips.idle);
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->damage_ns, 0);
  EXPECT_TRUE(std::isinf(trial->first_contact_s));
}

TEST(Oracle, ClipsThatCannotAnswerAreNotTried) {
  const Oracle oracle(trained().library);
  const features::Scenario& scenario = trained().observations[0].scenario;
  const runtime::Character character = tests::character_of(trained(), scenario);
  EXPECT_FALSE(oracle.try_clip(character, perceived(scenario), scenario.threat, -1));
  const auto count = static_cast<int>(trained().clips.clips.size());
  EXPECT_FALSE(oracle.try_clip(character, perceived(scenario), scenario.threat, count));
}

}  // namespace
}  // namespace flinch::lookahead
