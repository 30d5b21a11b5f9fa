// SPDX-License-Identifier: MIT
#include "train/simulate/trial.h"

#include <algorithm>
#include <cmath>

#include "features/ball.h"
#include "runtime/response/response.h"
#include "sim/work.h"

namespace flinch::train {

namespace {

std::size_t interval_count(double duration_s, float rate_hz) {
  return static_cast<std::size_t>(std::ceil(duration_s * double{rate_hz}));
}

/// Returns the poses of a response at the library's rate, from perception to at least `duration_s`.
motion::Motion sampled(const runtime::Response& response, float rate_hz, double duration_s) {
  const std::size_t intervals = interval_count(duration_s, rate_hz);
  motion::Motion motion;
  motion.rate_hz = rate_hz;
  motion.poses.reserve(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k)
    motion.poses.push_back(runtime::pose_at(response, static_cast<float>(k) / rate_hz));
  return motion;
}

/// Returns the work from the first movement to the end of the return. Idling costs nothing, because
/// the character would do it anyway.
double response_work_j(const SimulationSetup& setup, const runtime::Response& response,
                       const motion::Motion& motion) {
  if (response.clip == setup.library.idle) return 0;
  const auto pose_number = [&motion](float time_s) {
    return std::min(static_cast<std::size_t>(std::max(time_s, 0.0F) * motion.rate_hz),
                    motion.poses.size() - 1);
  };
  motion::Motion moving;
  moving.rate_hz = motion.rate_hz;
  moving.poses.assign(
      motion.poses.begin() + static_cast<std::ptrdiff_t>(pose_number(response.first_motion_s)),
      motion.poses.begin() +
          static_cast<std::ptrdiff_t>(pose_number(runtime::duration_s(response)) + 1));
  return sum(sim::mechanical_work(setup.library.character, moving));
}

/// The simulated part of a response.
struct SimulatedMotion {
  motion::Motion motion;  ///< up to the end of the simulation
  double simulated_s = 0;
  double work_j = 0;  ///< of the whole response
};

SimulatedMotion make_simulated_motion(const SimulationSetup& setup,
                                      const features::CharacterState& state, int clip,
                                      float time_to_impact_s) {
  const runtime::Response response =
      runtime::make_response(setup.prepared, state, clip, time_to_impact_s);
  const float rate_hz = setup.library.rate_hz;
  SimulatedMotion simulated_motion;
  simulated_motion.simulated_s = double{time_to_impact_s} + setup.plan.tail_s;
  // Velocities up to the end need two more poses.
  const double needed_s = simulated_motion.simulated_s + 2 / double{rate_hz};
  simulated_motion.motion =
      sampled(response, rate_hz, std::max(needed_s, double{runtime::duration_s(response)}));
  simulated_motion.work_j = response_work_j(setup, response, simulated_motion.motion);
  std::vector<motion::Pose>& poses = simulated_motion.motion.poses;
  poses.resize(std::min(poses.size(), interval_count(needed_s, rate_hz) + 1));
  poses.shrink_to_fit();
  return simulated_motion;
}

TrialResult trial_result(int clip, double work_j, const sim::SimulationResult& simulated) {
  TrialResult result{{}, simulated};
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
  observation.features =
      features::to_vector(features::features_of(observation.scenario, setup.idle()));
  for (const int clip : clips_to_try(library, observation.scenario.target)) {
    Trial trial;
    trial.clip = clip;
    observation.trials.push_back(trial);
  }
  return observation;
}

std::vector<int> clips_to_try(const database::ClipLibrary& library, motion::Target threatened) {
  std::vector<int> clips;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& candidate = library.clip(clip);
    const bool allowed = candidate.purpose == motion::Purpose::anticipation &&
                         features::is_allowed(threatened, candidate.annotation);
    if (clip == library.idle || allowed) clips.push_back(clip);
  }
  return clips;
}

TrialResult try_unabridged(const SimulationSetup& setup, const features::Scenario& scenario,
                           int clip) {
  const SimulatedMotion simulated_motion =
      make_simulated_motion(setup, scenario.state, clip, scenario.time_to_impact_s);
  const features::Ball ball = ball_of(scenario.threat, setup.plan.options.gravity_mps2);
  return trial_result(clip, simulated_motion.work_j,
                      setup.reference_simulator.simulate(simulated_motion.motion, &ball,
                                                         simulated_motion.simulated_s));
}

Trial try_clip(const SimulationSetup& setup, const features::Scenario& scenario, int clip) {
  return try_unabridged(setup, scenario, clip).trial;
}

RehearsedResponse rehearse(const SimulationSetup& setup, const ResponseKey& key) {
  const ScenarioDistribution& distribution = setup.plan.distribution;
  const SimulatedMotion simulated_motion =
      make_simulated_motion(setup, character_state_at(distribution, setup.idle(), key.cell),
                            key.clip, time_to_impact_s(distribution, key.cell.time));
  return {key, setup.simulator.rehearse(simulated_motion.motion, 0, simulated_motion.simulated_s),
          static_cast<float>(simulated_motion.work_j)};
}

std::vector<TrialResult> try_rehearsed(const SimulationSetup& setup,
                                       std::span<const RehearsedTrial> trials) {
  std::vector<sim::Throw> throws;
  throws.reserve(trials.size());
  for (const auto& [scenario, response] : trials) {
    const float rehearsed_s = time_to_impact_s(setup.plan.distribution, response.key.cell.time);
    const double later_s = double{scenario.time_to_impact_s} - double{rehearsed_s};
    throws.push_back({response.rehearsal,
                      ball_of(scenario.threat, setup.plan.options.gravity_mps2).at(later_s)});
  }
  const std::vector<sim::SimulationResult> simulated = setup.simulator.simulate(throws);
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
  const motion::Motion reference =
      sampled(response, setup.library.rate_hz, double{runtime::duration_s(response)});
  return response_work_j(setup, response, reference);
}

}  // namespace flinch::train
