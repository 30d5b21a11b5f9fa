// SPDX-License-Identifier: MIT
// Compares rehearsed simulations with unabridged ones, over all clips of a library's first
// scenarios, and prints the table of docs/simulation.md:
//
//     rehearsal_study LIBRARY [SCENARIOS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "database/files/library_writer.h"
#include "runtime/response/response.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "train/fit/labels.h"
#include "train/simulate/simulate.h"

namespace flinch {
namespace {

using motion::Body;

constexpr double kMaxChange = 0.005;  // a smaller change of an impulse counts as none
constexpr std::size_t kWorst = 10;

/// Adds the time since `begin_s` to `sum_s`, and restarts.
void add_time(double& begin_s, double& sum_s) {
  const double now_s = bench::process_cpu_s();
  sum_s += now_s - begin_s;
  begin_s = now_s;
}

template <class T>
double total(const motion::PerBody<T>& impulse) {
  double sum = 0;
  for (const T of_body : impulse) sum += double{of_body};
  return sum;
}

struct Pair {
  std::uint64_t scenario = 0;
  int clip = 0;
  double expected_ns = 0;
  double found_ns = 0;
  double change = 0;  ///< sum of the bodies' differences, divided by the total
  double contact_later_s = 0;
  std::string changed;  ///< the bodies that differ and by how much, N·s
};

struct Study {
  std::vector<Pair> pairs;
  std::uint64_t scenarios = 0;
  std::uint64_t same_best = 0;
  double posing_s = 0;
  double unabridged_s = 0;
  double rehearsing_s = 0;
  double rehearsed_s = 0;
  double unabridged_steps = 0;
  double steps = 0;
  int skipped = 0;
  int messages = 0;
  double bytes = 0;
};

motion::Motion performed(const train::SimulationSetup& setup, const features::Scenario& scenario,
                         int clip, double duration_s) {
  const runtime::Response response =
      runtime::make_response(setup.prepared, scenario.state, clip, scenario.time_to_impact_s);
  motion::Motion motion;
  motion.rate_hz = setup.library.rate_hz;
  const auto last = static_cast<std::size_t>(std::ceil(duration_s * double{motion.rate_hz}));
  for (std::size_t k = 0; k <= last; ++k) {
    motion.poses.push_back(
        runtime::pose_at(response, static_cast<float>(k) / setup.library.rate_hz));
  }
  return motion;
}

Pair try_both_ways(const train::SimulationSetup& setup, const features::Scenario& scenario,
                   int clip, Study& study, motion::PerBody<float>& expected,
                   motion::PerBody<float>& found) {
  const double duration_s = double{scenario.time_to_impact_s} + setup.plan.tail_s;
  const features::Ball ball = features::ball_of(scenario.threat);
  double time_s = bench::process_cpu_s();
  const motion::Motion motion = performed(setup, scenario, clip, duration_s);
  add_time(time_s, study.posing_s);
  const sim::SimulationResult slow = setup.reference_simulator.simulate(motion, &ball, duration_s);
  add_time(time_s, study.unabridged_s);
  const sim::Rehearsal rehearsal = setup.simulator.rehearse(motion, 0, duration_s);
  add_time(time_s, study.rehearsing_s);
  const sim::SimulationResult fast = setup.simulator.simulate(rehearsal, ball);
  add_time(time_s, study.rehearsed_s);

  study.unabridged_steps += slow.steps;
  study.steps += fast.steps;
  study.skipped += fast.skipped;
  study.messages += fast.solver_messages;
  study.bytes += static_cast<double>(rehearsal.byte_count());
  Pair pair{0,
            clip,
            total(slow.impulse),
            total(fast.impulse),
            0,
            fast.first_contact_s - slow.first_contact_s,
            {}};
  for (const Body body : motion::kBodies) {
    expected[body] = static_cast<float>(slow.impulse[body]);
    found[body] = static_cast<float>(fast.impulse[body]);
    const double change = fast.impulse[body] - slow.impulse[body];
    pair.change += std::abs(change);
    if (std::abs(change) < 1e-3) continue;
    char text[64];
    std::snprintf(text, sizeof text, " %s %+.3f", std::string(name_of(body)).c_str(), change);
    pair.changed += text;
  }
  const double whole = std::max(pair.expected_ns, pair.found_ns);
  if (whole > 0) pair.change /= whole;
  return pair;
}

void compare_scenario(const train::SimulationSetup& setup, const train::CostModel& model,
                      std::uint64_t number, Study& study) {
  train::Observation observation = train::make_observation(setup, number);
  std::vector<train::Trial> rehearsed = observation.trials;
  for (std::size_t i = 0; i < rehearsed.size(); ++i) {
    train::Trial& trial = observation.trials[i];
    // The work comes from the library and is the same for both.
    trial.work_j = static_cast<float>(train::reference_work_j(setup, trial.clip));
    rehearsed[i].work_j = trial.work_j;
    study.pairs.push_back(try_both_ways(setup, observation.scenario, trial.clip, study,
                                        trial.impulse, rehearsed[i].impulse));
    study.pairs.back().scenario = number;
  }
  const auto costs = train::costs_of(observation.trials, 0, model);
  const std::size_t best = train::best_trial(observation.trials, costs);
  const std::size_t found = train::best_trial(rehearsed, train::costs_of(rehearsed, 0, model));
  ++study.scenarios;
  study.same_best += best == found;
  if (best != found) {
    std::printf("scenario %llu: best clip %d of cost %.4f, rehearsed %d of %.4f\n",
                static_cast<unsigned long long>(number), observation.trials[best].clip, costs[best],
                observation.trials[found].clip, costs[found]);
  }
}

double percent(std::ptrdiff_t count, std::size_t of) {
  return 100 * static_cast<double>(count) / static_cast<double>(of);
}

void print(Study study) {
  const auto count = static_cast<double>(study.pairs.size());
  const auto of = [&](auto&& is) {
    return std::count_if(study.pairs.begin(), study.pairs.end(), is);
  };
  const auto hits = of([](const Pair& p) { return p.expected_ns > 0; });
  const auto same = of([](const Pair& p) { return p.expected_ns > 0 && p.change <= kMaxChange; });
  const auto made = of([](const Pair& p) { return p.expected_ns == 0 && p.found_ns > 0; });
  const auto lost = of([](const Pair& p) { return p.expected_ns > 0 && p.found_ns == 0; });
  std::printf("\n| | |\n| --- | --- |\n");
  std::printf("| pairs of scenario and clip | %zu, of %llu scenarios |\n", study.pairs.size(),
              static_cast<unsigned long long>(study.scenarios));
  std::printf("| hits | %td |\n", hits);
  std::printf("| of them within 0.5 %% | %.2f %% |\n",
              percent(same, static_cast<std::size_t>(hits)));
  std::printf("| misses turned into hits, hits into misses | %td, %td |\n", made, lost);
  std::printf("| scenarios with the same best clip | %.2f %% |\n",
              percent(static_cast<std::ptrdiff_t>(study.same_best), study.scenarios));
  std::printf("| skipped | %.1f %% |\n", 100 * study.skipped / count);
  std::printf("| steps, unabridged and rehearsed | %.1f, %.1f |\n", study.unabridged_steps / count,
              study.steps / count);
  std::printf("| ms unabridged | %.3f |\n", 1e3 * study.unabridged_s / count);
  std::printf("| ms rehearsed | %.4f |\n", 1e3 * study.rehearsed_s / count);
  std::printf("| a CPU-second, unabridged and rehearsed | %.0f, %.0f |\n",
              count / study.unabridged_s, count / study.rehearsed_s);
  std::printf("| times as many | %.1f |\n", study.unabridged_s / study.rehearsed_s);
  std::printf("| ms to pose a response, to rehearse it | %.3f, %.3f |\n",
              1e3 * study.posing_s / count, 1e3 * study.rehearsing_s / count);
  std::printf("| kB a rehearsal | %.0f |\n", study.bytes / count / 1e3);
  std::printf("| messages | %d |\n\nThe worst:\n\n", study.messages);
  std::sort(study.pairs.begin(), study.pairs.end(),
            [](const Pair& a, const Pair& b) { return a.change > b.change; });
  for (std::size_t i = 0; i < std::min(kWorst, study.pairs.size()); ++i) {
    const Pair& p = study.pairs[i];
    std::printf("- scenario %llu, clip %d: %.4f N s, %.2f %%:%s; contact %.6f s later\n",
                static_cast<unsigned long long>(p.scenario), p.clip, p.expected_ns, 100 * p.change,
                p.changed.c_str(), p.contact_later_s);
  }
}

void run(const bench::StudyArguments& arguments) {
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  const auto scenarios = arguments.number_or<std::uint64_t>(1, 200);
  const train::SimulationSetup setup(library, {});
  const train::CostModel model =
      train::make_cost_model(train::make_store_header(setup), train::vulnerability_profiles()[0],
                             train::CostModel{}.brawn);
  Study study;
  for (std::uint64_t number = 0; number < scenarios; ++number) {
    compare_scenario(setup, model, number, study);
  }
  print(std::move(study));
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"rehearsal_study LIBRARY [SCENARIOS]", 1, 2},
                                   flinch::run);
}
