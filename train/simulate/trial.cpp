// SPDX-License-Identifier: MIT
#include "train/simulate/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "features/ball.h"
#include "lookahead/oracle/oracle.h"
#include "lookahead/oracle/response_motion.h"
#include "motion/error.h"
#include "runtime/response/response.h"

namespace flinch::train {

namespace {

lookahead::ResponseMotion response_motion(const SimulationSetup& setup,
                                          const features::CharacterState& state, int clip,
                                          float time_to_impact_s) {
  return lookahead::make_response_motion(
      setup.prepared, runtime::make_response(setup.prepared, state, clip, time_to_impact_s),
      double{time_to_impact_s} + setup.plan.tail_s);
}

std::int16_t millimetres(double metres) {
  constexpr double kMax = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::clamp(std::round(1000 * metres), -kMax, kMax));
}

/// A contact takes several steps: an impulse within kMergeDistance_m of an earlier place of the
/// same body is added to that place. Once there are kMany places, each impulse is added to the
/// nearest one of its body, however far: a ball that rolls would need more places than a store
/// holds.
std::vector<HitPlace> places_of(int clip, std::span<const sim::PlacedImpulse> impulses) {
  constexpr float kMergeDistance_m = 0.005F;
  constexpr std::size_t kMany = kMaxPlacesPerTrial - motion::kBodyCount;
  std::vector<HitPlace> places;
  for (const sim::PlacedImpulse& hit : impulses) {
    const HitPlace place{
        clip,
        hit.body,
        static_cast<float>(hit.impulse_ns),
        {millimetres(hit.point.x()), millimetres(hit.point.y()), millimetres(hit.point.z())}};
    HitPlace* nearest = nullptr;
    float distance_m =
        places.size() < kMany ? kMergeDistance_m : std::numeric_limits<float>::infinity();
    for (HitPlace& other : places) {
      const float apart_m = (point_of(other) - point_of(place)).norm();
      if (other.body != place.body || apart_m > distance_m) continue;
      nearest = &other;
      distance_m = apart_m;
    }
    if (nearest != nullptr) {
      nearest->impulse_ns += place.impulse_ns;
    } else {
      places.push_back(place);
    }
  }
  return places;
}

TrialResult trial_result(int clip, double work_j, const sim::SimulationResult& simulated) {
  if (!simulated.is_finite)
    throw Error("simulation", "the numbers of clip " + std::to_string(clip) +
                                  "'s simulation are not finite; check the library's motions");
  TrialResult result{{}, places_of(clip, simulated.places), simulated};
  result.trial.clip = clip;
  result.trial.work_j = static_cast<float>(work_j);
  for (const motion::Body body : motion::kBodies)
    result.trial.impulse[body] = static_cast<float>(simulated.impulse[body]);
  return result;
}

}  // namespace

SimulationSetup::SimulationSetup(const database::ClipLibrary& simulated,
                                 const SimulationPlan& planned)
    : library(simulated),
      prepared(runtime::prepare(simulated)),
      stances(stance_loops(simulated)),
      plan(planned),
      body_model(motion::make_body_model(simulated.character)),
      simulator(simulated.character, planned.options),
      reference_simulator(simulated.character, planned.options),
      responses(prepared, planned.distribution) {}

Observation make_observation(const SimulationSetup& setup, std::uint64_t number) {
  const database::ClipLibrary& library = setup.library;
  Observation observation;
  observation.number = number;
  observation.scenario =
      sample_scenario(library, setup.body_model, setup.plan.distribution, setup.plan.seed, number);
  const auto stance = static_cast<std::size_t>(observation.scenario.state.stance);
  observation.features =
      features::to_vector(features::features_of(observation.scenario, setup.stances[stance]));
  for (const int clip : lookahead::clips_to_try(library, observation.scenario.target)) {
    Trial trial;
    trial.clip = clip;
    observation.trials.push_back(trial);
  }
  return observation;
}

TrialResult try_unabridged(const SimulationSetup& setup, const features::Scenario& scenario,
                           int clip) {
  const lookahead::ResponseMotion tracked =
      response_motion(setup, scenario.state, clip, scenario.time_to_impact_s);
  const features::Ball ball = ball_of(scenario.threat, setup.plan.options.gravity_mps2);
  return trial_result(
      clip, tracked.work_j,
      setup.reference_simulator.simulate(tracked.motion, &ball, tracked.simulated_s));
}

Trial try_clip(const SimulationSetup& setup, const features::Scenario& scenario, int clip) {
  return try_unabridged(setup, scenario, clip).trial;
}

RehearsedResponse rehearse(const SimulationSetup& setup, const ResponseKey& key) {
  const ScenarioDistribution& distribution = setup.plan.distribution;
  const lookahead::ResponseMotion tracked =
      response_motion(setup, character_state_at(distribution, setup.stances, key.cell), key.clip,
                      time_to_impact_s(distribution, key.cell.time));
  return {key, setup.simulator.rehearse(tracked.motion, 0, tracked.simulated_s),
          static_cast<float>(tracked.work_j)};
}

std::vector<TrialResult> try_rehearsed(const SimulationSetup& setup,
                                       std::span<const RehearsedTrial> trials,
                                       sim::ThrowSimulator& throws) {
  std::vector<sim::Throw> thrown;
  thrown.reserve(trials.size());
  for (const auto& [scenario, response] : trials) {
    const float rehearsed_s = time_to_impact_s(setup.plan.distribution, response.key.cell.time);
    const double later_s = double{scenario.time_to_impact_s} - double{rehearsed_s};
    thrown.push_back({response.rehearsal,
                      ball_of(scenario.threat, setup.plan.options.gravity_mps2).at(later_s)});
  }
  const std::vector<sim::SimulationResult> simulated = throws.simulate(thrown);
  std::vector<TrialResult> results;
  results.reserve(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const RehearsedResponse& response = trials[i].response;
    results.push_back(trial_result(response.key.clip, double{response.work_j}, simulated[i]));
  }
  return results;
}

double reference_work_j(const SimulationSetup& setup, int clip) {
  const auto& annotation = setup.library.clip(clip).annotation;
  if (clip == setup.library.idle || !annotation) return 0;
  // With enough time to shift the weight, the clip plays at its own speed.
  constexpr float kShiftTime_s = 0.5F;  // s
  const runtime::Response response =
      runtime::make_response(setup.prepared, {}, clip, annotation->peak_s + kShiftTime_s);
  return lookahead::response_work_j(setup.prepared, response);
}

}  // namespace flinch::train
