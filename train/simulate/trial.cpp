// SPDX-License-Identifier: MIT
#include "train/simulate/trial.h"

#include <algorithm>
#include <cmath>

#include "features/free_flight.h"
#include "runtime/response/response.h"
#include "sim/work.h"

namespace flinch::train {

namespace {

double sum(const motion::PerBody<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

std::size_t interval_count(double duration_s, float rate_hz) {
  return static_cast<std::size_t>(std::ceil(duration_s * double{rate_hz}));
}

/// Poses of a response at the library's rate, from perception to `duration_s` at least.
motion::Motion sampled(const runtime::Response& response, float rate_hz, double duration_s) {
  const std::size_t intervals = interval_count(duration_s, rate_hz);
  motion::Motion motion;
  motion.rate_hz = rate_hz;
  motion.poses.reserve(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k)
    motion.poses.push_back(runtime::pose_at(response, static_cast<float>(k) / rate_hz));
  return motion;
}

/// Work from the first movement to the end of the way back. Idling costs nothing: it is what the
/// character would do anyway.
double response_work_j(const SimulationSubject& subject, const runtime::Response& response,
                       const motion::Motion& motion) {
  if (response.clip == subject.library.idle) return 0;
  const auto pose_number = [&motion](float time_s) {
    return std::min(static_cast<std::size_t>(std::max(time_s, 0.0F) * motion.rate_hz),
                    motion.poses.size() - 1);
  };
  motion::Motion moving;
  moving.rate_hz = motion.rate_hz;
  moving.poses.assign(
      motion.poses.begin() + static_cast<std::ptrdiff_t>(pose_number(response.start_s)),
      motion.poses.begin() +
          static_cast<std::ptrdiff_t>(pose_number(runtime::duration_s(response)) + 1));
  return sum(sim::mechanical_work(subject.library.character, moving));
}

/// A response as it is simulated.
struct Performance {
  motion::Motion motion;  ///< as far as it is simulated
  double simulated_s = 0;
  double work_j = 0;  ///< of all of it
};

Performance perform(const SimulationSubject& subject, const features::CharacterState& state,
                    int clip, float time_to_impact_s) {
  const runtime::Response response =
      runtime::make_response(subject.prepared, state, clip, time_to_impact_s);
  const float rate_hz = subject.library.rate_hz;
  Performance performance;
  performance.simulated_s = double{time_to_impact_s} + subject.plan.tail_s;
  // Velocities on the way to the end take two more poses.
  const double needed_s = performance.simulated_s + 2 / double{rate_hz};
  performance.motion =
      sampled(response, rate_hz, std::max(needed_s, double{runtime::duration_s(response)}));
  performance.work_j = response_work_j(subject, response, performance.motion);
  std::vector<motion::Pose>& poses = performance.motion.poses;
  poses.resize(std::min(poses.size(), interval_count(needed_s, rate_hz) + 1));
  poses.shrink_to_fit();
  return performance;
}

/// The ball `later_s` after perception.
sim::Ball ball_of(const features::Threat& threat, double later_s, double gravity_mps2) {
  const double radius = double{threat.radius};
  const features::FreeFlight flight{threat.position.cast<double>(), threat.velocity.cast<double>(),
                                    radius, gravity_mps2};
  return {flight.position_at(later_s), flight.velocity_at(later_s), radius, double{threat.mass_kg}};
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

SimulationSubject::SimulationSubject(const database::Library& simulated,
                                     const SimulationPlan& planned)
    : library(simulated),
      prepared(runtime::prepare(simulated)),
      plan(planned),
      body_model(motion::make_body_model(simulated.character)),
      simulator(simulated.character, planned.options),
      responses(prepared, planned.distribution) {}

Observation pose_scenario(const SimulationSubject& subject, std::uint64_t number) {
  const database::Library& library = subject.library;
  Observation observation;
  observation.number = number;
  observation.scenario = sample_scenario(library, subject.body_model, subject.plan.distribution,
                                         subject.plan.seed, number);
  observation.features =
      features::to_vector(features::features_of(observation.scenario, subject.idle()));
  for (const int clip : clips_to_try(library, observation.scenario.target)) {
    Trial trial;
    trial.clip = clip;
    observation.trials.push_back(trial);
  }
  return observation;
}

std::vector<int> clips_to_try(const database::Library& library, motion::Target threatened) {
  std::vector<int> clips;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& candidate = library.clips[static_cast<std::size_t>(clip)];
    const bool allowed = candidate.purpose == motion::Purpose::anticipation &&
                         features::is_allowed(threatened, candidate.annotation);
    if (clip == library.idle || allowed) clips.push_back(clip);
  }
  return clips;
}

TrialResult try_unabridged(const SimulationSubject& subject, const features::Scenario& scenario,
                           int clip) {
  const Performance performance = perform(subject, scenario.state, clip, scenario.time_to_impact_s);
  const sim::Ball ball = ball_of(scenario.threat, 0, subject.plan.options.gravity_mps2);
  return trial_result(
      clip, performance.work_j,
      subject.simulator.simulate(performance.motion, &ball, performance.simulated_s));
}

Trial try_clip(const SimulationSubject& subject, const features::Scenario& scenario, int clip) {
  return try_unabridged(subject, scenario, clip).trial;
}

RehearsedResponse rehearse(const SimulationSubject& subject, const ResponseKey& key) {
  const ScenarioDistribution& distribution = subject.plan.distribution;
  const Performance performance =
      perform(subject, character_state_at(distribution, subject.idle(), key.place), key.clip,
              time_to_impact_s(distribution, key.place.time));
  return {key, subject.simulator.rehearse(performance.motion, 0, performance.simulated_s),
          static_cast<float>(performance.work_j)};
}

TrialResult try_rehearsed(const SimulationSubject& subject, const features::Scenario& scenario,
                          const RehearsedResponse& response) {
  const float rehearsed_s = time_to_impact_s(subject.plan.distribution, response.key.place.time);
  const double later_s = double{scenario.time_to_impact_s} - double{rehearsed_s};
  const sim::Ball ball = ball_of(scenario.threat, later_s, subject.plan.options.gravity_mps2);
  return trial_result(response.key.clip, double{response.work_j},
                      subject.simulator.simulate(response.rehearsal, ball));
}

double reference_work_j(const SimulationSubject& subject, int clip) {
  const auto& annotation = subject.library.clips[static_cast<std::size_t>(clip)].annotation;
  if (clip == subject.library.idle || !annotation) return 0;
  // With time enough to shift the weight, the clip plays unhurried.
  constexpr float kTimeToShift = 0.5F;  // s
  const runtime::Response response =
      runtime::make_response(subject.prepared, {}, clip, annotation->peak_s + kTimeToShift);
  const motion::Motion reference =
      sampled(response, subject.library.rate_hz, double{runtime::duration_s(response)});
  return response_work_j(subject, response, reference);
}

}  // namespace flinch::train
