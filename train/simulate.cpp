// SPDX-License-Identifier: MIT
#include "train/simulate.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "database/library_writer.h"
#include "database/sealed_file.h"
#include "motion/error.h"
#include "runtime/response.h"
#include "sim/work.h"

namespace flinch::train {

namespace {

/// Scenarios that are simulated and committed together: enough trials to keep many threads busy,
/// and seconds of work to lose to a Ctrl-C.
constexpr std::uint64_t kBatch = 16;

double sum(const motion::PerBody<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

/// Poses of a response at the library's rate, from perception to at least `duration_s`.
motion::Motion sampled(const runtime::Response& response, float rate_hz, double duration_s) {
  const auto intervals = static_cast<std::size_t>(std::ceil(duration_s * double{rate_hz}));
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

sim::Ball ball_of(const features::Threat& threat) {
  return {threat.position.cast<double>(), threat.velocity.cast<double>(), double{threat.radius},
          double{threat.mass_kg}};
}

constexpr double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

std::string describe(const ScenarioDistribution& distribution) {
  return nlohmann::ordered_json{
      {"radius_m", distribution.radius_m},
      {"mass_kg", distribution.mass_kg},
      {"speed_mps", {distribution.least_speed_mps, distribution.most_speed_mps}},
      {"elevation_degrees",
       {degrees(distribution.least_elevation), degrees(distribution.most_elevation)}},
      {"time_to_impact_s",
       {distribution.least_time_to_impact_s, distribution.most_time_to_impact_s}},
      {"aim_radius_m", distribution.aim_radius_m}}
      .dump();
}

std::string describe(const SimulationPlan& plan) {
  return nlohmann::ordered_json{{"free_step_s", plan.options.free_step_s},
                                {"contact_step_s", plan.options.contact_step_s},
                                {"restitution", plan.options.restitution},
                                {"gravity_mps2", plan.options.gravity_mps2},
                                {"tail_s", plan.tail_s}}
      .dump();
}

/// The first thing thrown by any of several threads.
class FirstException {
 public:
  void keep_current() {
    const std::lock_guard lock(mutex_);
    if (!exception_) exception_ = std::current_exception();
    thrown_ = true;
  }
  bool thrown() const { return thrown_; }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::atomic<bool> thrown_ = false;
};

}  // namespace

SimulationSubject::SimulationSubject(const database::Library& simulated,
                                     const SimulationPlan& planned)
    : library(simulated),
      prepared(runtime::prepare(simulated)),
      plan(planned),
      body_model(motion::make_body_model(simulated.character)),
      simulator(simulated.character, planned.options) {}

Observation pose_scenario(const SimulationSubject& subject, std::uint64_t number) {
  const database::Library& library = subject.library;
  Observation observation;
  observation.number = number;
  observation.scenario = sample_scenario(library, subject.body_model, subject.plan.distribution,
                                         subject.plan.seed, number);
  observation.features = features::to_vector(features::features_of(
      observation.scenario, library.clips[static_cast<std::size_t>(library.idle)].motion));
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

Trial try_clip(const SimulationSubject& subject, const features::Scenario& scenario, int clip) {
  const runtime::Response response =
      runtime::make_response(subject.prepared, scenario.state, clip, scenario.time_to_impact_s);
  const double simulated_s = double{scenario.time_to_impact_s} + subject.plan.tail_s;
  const motion::Motion reference =
      sampled(response, subject.library.rate_hz,
              std::max(simulated_s, double{runtime::duration_s(response)}));
  const sim::Ball ball = ball_of(scenario.threat);
  const sim::SimulationResult result = subject.simulator.simulate(reference, &ball, simulated_s);
  Trial trial;
  trial.clip = clip;
  trial.work_j = static_cast<float>(response_work_j(subject, response, reference));
  for (const motion::Body body : motion::kBodies)
    trial.impulse[body] = static_cast<float>(result.impulse[body]);
  return trial;
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

StoreHeader make_store_header(const SimulationSubject& subject) {
  const database::Library& library = subject.library;
  StoreHeader header;
  const std::string file = database::library_bytes(library);
  const auto bytes = std::as_bytes(std::span(file));
  header.library_file.assign(bytes.begin(), bytes.end());
  header.library_hash = database::unseal(database::kLibraryKind, bytes).hash;
  header.library_name = library.name;
  header.seed = subject.plan.seed;
  header.distribution = describe(subject.plan.distribution);
  header.simulation = describe(subject.plan);
  header.reference_impulse_ns = (1 + subject.plan.options.restitution) *
                                subject.plan.distribution.mass_kg *
                                subject.plan.distribution.most_speed_mps;
  header.idle = library.idle;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& source = library.clips[static_cast<std::size_t>(clip)];
    const bool answers = source.purpose == motion::Purpose::anticipation && clip != library.idle;
    header.clips.push_back({source.name, answers ? source.annotation : std::nullopt});
    header.clip_work_j.push_back(answers ? reference_work_j(subject, clip) : 0);
  }
  header.reference_work_j = *std::ranges::max_element(header.clip_work_j);
  if (!(header.reference_work_j > 0))
    throw Error("", "the library " + library.name +
                        " has no annotated clip that moves; annotate its clips in the manifest "
                        "and import again");
  const motion::Motion& idle = library.clips[static_cast<std::size_t>(library.idle)].motion;
  header.idle_target_centres = target_centres_in_character_frame(
      library.character.skeleton, subject.body_model, idle.poses.front());
  return header;
}

bool simulate_batch(const SimulationSubject& subject, int threads, std::uint64_t first,
                    std::vector<Observation>& observations, const std::atomic<bool>& stop) {
  // Single trials, not scenarios, are shared out, so that no thread waits long for the last one.
  std::vector<std::pair<std::size_t, std::size_t>> trials;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    observations[i] = pose_scenario(subject, first + i);
    for (std::size_t j = 0; j < observations[i].trials.size(); ++j) trials.emplace_back(i, j);
  }
  FirstException failure;
#pragma omp parallel for num_threads(threads) schedule(dynamic)
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (stop || failure.thrown()) continue;
    try {
      Observation& observation = observations[trials[k].first];
      Trial& trial = observation.trials[trials[k].second];
      trial = try_clip(subject, observation.scenario, trial.clip);
    } catch (...) {
      failure.keep_current();
    }
  }
  failure.rethrow();
  return !stop;
}

bool simulate_store(const SimulationSubject& subject, const std::string& path,
                    std::uint64_t scenarios, int threads, const std::atomic<bool>& stop,
                    const std::function<void(const SimulationProgress&)>& report) {
  const StoreHeader header = make_store_header(subject);
  const ScenarioRange wanted{0, scenarios};
  SimulationProgress progress;
  progress.of = scenarios;
  if (std::filesystem::is_regular_file(path)) {
    const StoreSummary finished = summarise_store(path);
    require_same_run(finished.header, header, path);
    progress.scenarios = finished.observation_count;
    if (finished.holds(wanted)) {
      report(progress);
      return true;
    }
  }
  StoreWriter writer(path, header, wanted);
  progress.scenarios = writer.count();
  report(progress);
  while (!writer.missing().empty()) {
    const ScenarioRange missing = writer.missing().front();
    const std::uint64_t first = missing.first;
    // Batches begin at multiples of their size, wherever an earlier run was stopped.
    const std::uint64_t end = std::min(missing.end(), (first / kBatch + 1) * kBatch);
    std::vector<Observation> observations(end - first);
    if (!simulate_batch(subject, threads, first, observations, stop)) return false;
    writer.append(observations);
    progress.scenarios = writer.count();
    for (const Observation& observation : observations)
      progress.simulations += observation.trials.size();
    report(progress);
  }
  writer.finish();
  return true;
}

}  // namespace flinch::train
