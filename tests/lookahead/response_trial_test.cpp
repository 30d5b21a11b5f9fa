// SPDX-License-Identifier: MIT
#include "lookahead/response_trial.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/lookahead/trained_library.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::lookahead {
namespace {

using tests::trained;

constexpr double kTail_s = 0.3;  // train::SimulationPlan::tail_s

TrialResult trial_of(ResponseTrial& trial, const features::Scenario& scenario, int clip,
                     double max_damage_ns = std::numeric_limits<double>::infinity()) {
  const runtime::Response response = runtime::make_response(
      trained().library.prepared(), scenario.state, clip, scenario.time_to_impact_s);
  trial.follow(response, trained().clips.rate_hz);
  return trial.meet(features::ball_of(scenario.threat), double{scenario.time_to_impact_s} + kTail_s,
                    trained().costs().vulnerability, max_damage_ns);
}

ResponseTrial make_trial() {
  return {*trained().data->figure, double{trained().library.prepared().reach_m}};
}

TEST(ResponseTrial, ForeseesWhatTrainingMeasures) {
  ResponseTrial trial = make_trial();
  int pairs = 0;
  int same_hit = 0;
  int near = 0;
  for (const train::Observation& observation : trained().observations) {
    for (const train::Trial& measured : observation.trials) {
      const double expected = train::damage_ns(measured.impulse, trained().costs().vulnerability);
      const double found = trial_of(trial, observation.scenario, measured.clip).damage_ns;
      ++pairs;
      same_hit += (expected > 0) == (found > 0);
      near += std::abs(expected - found) <= 0.01 * expected;
    }
  }
  EXPECT_GT(pairs, 400);
  EXPECT_GE(same_hit, 0.99 * pairs);
  EXPECT_GE(near, 0.95 * pairs);
}

TEST(ResponseTrial, LeavesNothingBehind) {
  ResponseTrial used = make_trial();
  for (std::size_t i = 0; i < 20; ++i) {
    const train::Observation& observation = trained().observations[i];
    const int clip = observation.trials[i % observation.trials.size()].clip;
    // Another response at the same times.
    trial_of(used, observation.scenario,
             observation.trials[(i + 1) % observation.trials.size()].clip);
    ResponseTrial fresh = make_trial();
    const TrialResult expected = trial_of(fresh, observation.scenario, clip);
    const TrialResult found = trial_of(used, observation.scenario, clip);
    EXPECT_EQ(std::memcmp(&expected.impulse, &found.impulse, sizeof found.impulse), 0);
    EXPECT_EQ(expected.first_contact_s, found.first_contact_s);
    EXPECT_EQ(expected.steps, found.steps);
  }
}

TEST(ResponseTrial, StopsAsSoonAsTheDamageExceedsTheLimit) {
  ResponseTrial trial = make_trial();
  int cut = 0;
  for (const train::Observation& observation : trained().observations) {
    const int clip = observation.trials.front().clip;
    const TrialResult whole = trial_of(trial, observation.scenario, clip);
    if (whole.damage_ns == 0) continue;
    const TrialResult part = trial_of(trial, observation.scenario, clip, 0.5 * whole.damage_ns);
    EXPECT_TRUE(part.is_cut);
    EXPECT_GT(part.damage_ns, 0.5 * whole.damage_ns);
    EXPECT_LE(part.damage_ns, whole.damage_ns);
    EXPECT_LE(part.steps, whole.steps);
    EXPECT_FALSE(trial_of(trial, observation.scenario, clip, whole.damage_ns).is_cut);
    ++cut;
  }
  EXPECT_GT(cut, 20);
}

TEST(ResponseTrial, GivesUpFewHitsThatTheLimitAllows) {
  ResponseTrial trial = make_trial();
  int hits = 0;
  int cut = 0;
  for (const train::Observation& observation : trained().observations) {
    for (const train::Trial& measured : observation.trials) {
      const double whole = trial_of(trial, observation.scenario, measured.clip).damage_ns;
      if (whole == 0) continue;
      ++hits;
      // A first hit differs by up to 1 % if it is simulated from further back.
      cut += trial_of(trial, observation.scenario, measured.clip, 1.01 * whole).is_cut;
    }
  }
  EXPECT_GT(hits, 400);
  EXPECT_LE(cut, 0.005 * hits);
}

TEST(ResponseTrial, GivesUpMostHitsFarBeyondTheLimitWithoutSimulatingThem) {
  ResponseTrial trial = make_trial();
  int hits = 0;
  int not_simulated = 0;
  for (const train::Observation& observation : trained().observations) {
    for (const train::Trial& measured : observation.trials) {
      const double whole = trial_of(trial, observation.scenario, measured.clip).damage_ns;
      if (whole == 0) continue;
      ++hits;
      not_simulated += trial_of(trial, observation.scenario, measured.clip, 0.5 * whole).steps == 0;
    }
  }
  EXPECT_GT(not_simulated, 0.7 * hits);
}

TEST(ResponseTrial, ABallThatPassesAtADistanceIsNotSimulated) {
  ResponseTrial trial = make_trial();
  features::Scenario scenario = trained().observations.front().scenario;
  scenario.threat.position = {10, 3, 1.5F};
  scenario.threat.velocity = {-20, 0, 2};
  const TrialResult result = trial_of(trial, scenario, trained().clips.idle);
  EXPECT_EQ(result.steps, 0);
  EXPECT_EQ(result.damage_ns, 0);
  EXPECT_TRUE(std::isinf(result.first_contact_s));
}

TEST(ResponseTrial, ABallThatBouncesBeforeTheFeetStillHitsThem) {
  ResponseTrial trial = make_trial();
  features::Scenario scenario;
  scenario.time_to_impact_s = 0.5F;
  scenario.threat.position = {6, 0.1F, 0.5F};
  scenario.threat.velocity = {-12, 0, -3};
  EXPECT_GT(trial_of(trial, scenario, trained().clips.idle).damage_ns, 0);
}

TEST(ResponseTrial, AllocatesNothing) {
  ResponseTrial trial = make_trial();
  for (const train::Observation& observation : trained().observations) {
    const std::size_t allocations = tests::allocation_count();
    for (const train::Trial& measured : observation.trials)
      trial_of(trial, observation.scenario, measured.clip);
    EXPECT_EQ(tests::allocation_count(), allocations) << "scenario " << observation.number;
  }
}

}  // namespace
}  // namespace flinch::lookahead
