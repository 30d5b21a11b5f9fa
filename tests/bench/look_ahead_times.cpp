// SPDX-License-Identifier: MIT
// Prints what looking ahead costs, the table of docs/look_ahead.md:
//
//     look_ahead_times SELECTOR
//
// For each k: the median and the 99th percentile of the time to perceive a threat, the median as a
// share of that of single encounters of the same candidates with their plans in the same run, and
// how many encounters were simulated.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "features/random.h"
#include "lookahead/look_ahead.h"
#include "lookahead/response_trial.h"
#include "models/selector.h"
#include "motion/error.h"
#include "runtime/response/prepared_library.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"

namespace flinch {
namespace {

constexpr std::size_t kThreats = 500;
constexpr double kTail_s = 0.3;  // SimulationPlan::tail_s

/// Balls as training throws them: 8 to 30 m/s from everywhere at every height of a character at the
/// origin.
std::vector<features::Threat> random_threats() {
  std::vector<features::Threat> threats;
  for (std::size_t i = 0; i < kThreats; ++i) {
    features::Random random(7, features::RandomStream::scenario, i);
    features::ThreatDescription approach;
    approach.azimuth = static_cast<float>(random.uniform(-3.1, 3.1));
    approach.elevation = static_cast<float>(random.uniform(0.1, 0.5));
    approach.speed_mps = static_cast<float>(random.uniform(8, 30));
    approach.time_to_impact_s = static_cast<float>(random.uniform(0.25, 1.2));
    const Eigen::Vector3f goal(0, 0, static_cast<float>(random.uniform(0.4, 1.7)));
    threats.push_back(features::threat_from_description(approach, goal, 0));
  }
  return threats;
}

struct Times {
  std::vector<double> us;
  double microseconds(double share) const { return bench::quantile(us, share); }
  void add(double begin_s) { us.push_back(1e6 * (bench::thread_cpu_s() - begin_s)); }
};

void print(const char* name, const Times& times) {
  std::printf("| %s | %.0f | %.0f |", name, times.microseconds(0.5), times.microseconds(0.99));
}

void run(const bench::StudyArguments& arguments) {
  runtime::Library library;
  if (library.load(arguments.text(0)) != database::LoadStatus::ok)
    throw Error(arguments.text(0), "cannot be loaded");
  const auto data = lookahead::make_look_ahead_data(library);
  lookahead::LookAheadWorkspace workspace;
  if (!workspace.reserve_memory(library, data))
    throw Error(arguments.text(0), "holds no costs; `flinch train` writes them");
  runtime::Workspace selection;
  selection.reserve_memory(library.selection_bytes());
  const std::vector<features::Threat> threats = random_threats();
  std::printf(
      "| perceive | median us | p99 us | of single encounters | simulated |\n"
      "| --- | --- | --- | --- | --- |\n");
  const auto time_of = [&](const features::Threat& threat, auto&& perceived) {
    runtime::Character character(library);
    character.place({0, 0}, 0, 0.5F);
    const double begin_s = bench::thread_cpu_s();
    perceived(character, threat);
    return begin_s;
  };
  Times plain;
  Times alone;
  const auto perceive_plainly = [&](const features::Threat& threat) {
    plain.add(time_of(threat, [&](runtime::Character& character, const features::Threat& thrown) {
      character.perceive(thrown, selection);
    }));
  };
  const auto perceive_alone = [&](const features::Threat& threat) {
    alone.add(time_of(threat, [&](runtime::Character& character, const features::Threat& thrown) {
      perceive(character, std::span(&thrown, 1), {.candidates = 1}, workspace);
    }));
  };
  // In turns, and each as often first, so that neither finds warmer caches.
  for (std::size_t i = 0; i < threats.size(); ++i) {
    if (i % 2 == 0) perceive_plainly(threats[i]);
    perceive_alone(threats[i]);
    if (i % 2 == 1) perceive_plainly(threats[i]);
  }
  print("without", plain);
  std::printf(" | |\n");
  print("k = 1", alone);
  std::printf(" | 0.0 |\n");
  lookahead::ResponseTrial trial(*data->figure, double{library.prepared().reach_m});
  const models::ResponseCosts& costs = *library.selector().costs;
  for (const int k : {2, 4, 8, 16}) {
    Times ahead;
    Times single;
    double encounters = 0;
    for (const features::Threat& threat : threats) {
      runtime::Character character(library);
      character.place({0, 0}, 0, 0.5F);
      runtime::Character before = character;
      double begin_s = bench::thread_cpu_s();
      const lookahead::LookAheadStatus status =
          perceive(character, std::span(&threat, 1), {.candidates = k}, workspace);
      ahead.add(begin_s);
      encounters += static_cast<double>(status.encounters);
      runtime::Perception perception;
      if (before.notice(threat, perception) != runtime::Status::ok) continue;
      begin_s = bench::thread_cpu_s();
      for (std::size_t i = 0; i < status.count; ++i) {
        trial.follow(before.plan(perception, status.candidates[i].candidate.clip),
                     library.clip_library().rate_hz);
        trial.meet(features::ball_of(threat),
                   double{perception.scenario.time_to_impact_s} + kTail_s,
                   vulnerability_to(costs, threat.kind));
      }
      single.add(begin_s);
    }
    print(("k = " + std::to_string(k)).c_str(), ahead);
    std::printf(" %.2f | %.1f |\n", ahead.microseconds(0.5) / single.microseconds(0.5),
                encounters / static_cast<double>(threats.size()));
  }
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"look_ahead_times SELECTOR", 1, 1},
                                   flinch::run);
}
