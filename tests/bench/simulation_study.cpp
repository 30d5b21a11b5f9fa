// SPDX-License-Identifier: MIT
// Prints the tables of docs/simulation.md:
//
//     simulation_study [LIBRARY]
//
// over the procedural motions and, if a library is given, each of its clips.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "database/files/library_writer.h"
#include "sim/ode/ode_simulator.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/sim/random_hits.h"

namespace flinch {
namespace {

using bench::quantile;

constexpr std::size_t kHits = 200;

struct Study {
  motion::Physique character;
  std::vector<scenes::NamedMotion> motions;
};

sim::SimulationOptions with_steps(double free_hz, double contact_hz) {
  sim::SimulationOptions options;
  options.free_step_s = 1 / free_hz;
  options.contact_step_s = 1 / contact_hz;
  return options;
}

std::vector<double> tracking_errors_mm(const Study& study, const sim::SimulationOptions& options) {
  const sim::OdeSimulator simulator(study.character, options);
  std::vector<double> errors;
  for (const auto& [name, motion] : study.motions) {
    const double duration_s = static_cast<double>(motion.duration_s());
    errors.push_back(1e3 * simulator.simulate(motion, nullptr, duration_s).tracking_error_m);
  }
  return errors;
}

void print_tracking(const Study& study) {
  std::printf("\n### Tracking: RMS distance of hands, feet and head, mm\n\n");
  std::printf("| free step | median | p90 | worst | of |\n| --- | --- | --- | --- | --- |\n");
  for (double free_hz : {30.0, 60.0, 120.0, 240.0}) {
    const auto errors = tracking_errors_mm(study, with_steps(free_hz, 2000));
    const auto worst = std::max_element(errors.begin(), errors.end());
    std::printf("| 1/%.0f s | %.1f | %.1f | %.1f | %s |\n", free_hz, quantile(errors, 0.5),
                quantile(errors, 0.9), *worst,
                study.motions[static_cast<std::size_t>(worst - errors.begin())].name.c_str());
  }
  const auto shipped = tracking_errors_mm(study, {});
  const auto within =
      std::count_if(shipped.begin(), shipped.end(), [](double e) { return e <= 50; });
  std::printf("\nWithin 50 mm as shipped: %td of %zu.\n", within, shipped.size());
  for (std::size_t i = 0; i < shipped.size(); ++i) {
    if (shipped[i] > 50) std::printf("- %s: %.1f mm\n", study.motions[i].name.c_str(), shipped[i]);
  }
}

struct Outcome {
  std::vector<sim::SimulationResult> results;
  double cpu_s = 0;
  double steps = 0;
  int most_steps = 0;
  int messages = 0;
};

Outcome outcome_of(const Study& study, const std::vector<scenes::Hit>& hits,
                   const sim::SimulationOptions& options) {
  const sim::OdeSimulator simulator(study.character, options);
  Outcome outcome;
  const double begin_s = bench::process_cpu_s();
  for (const scenes::Hit& hit : hits) {
    const motion::Motion& motion = study.motions[hit.motion].motion;
    const double duration_s = static_cast<double>(motion.duration_s());
    outcome.results.push_back(simulator.simulate(motion, &hit.ball, duration_s));
    outcome.steps += outcome.results.back().steps;
    outcome.most_steps = std::max(outcome.most_steps, outcome.results.back().steps);
    outcome.messages += outcome.results.back().solver_messages;
  }
  outcome.cpu_s = bench::process_cpu_s() - begin_s;
  return outcome;
}

/// sum over bodies |J - J'| / sum J', for those that hit.
std::vector<double> changes_percent(const Outcome& from, const Outcome& to) {
  std::vector<double> changes;
  for (std::size_t i = 0; i < to.results.size(); ++i) {
    const double whole = std::max(sum(from.results[i].impulse), sum(to.results[i].impulse));
    if (whole == 0) continue;
    double change = 0;
    for (motion::Body body : motion::kBodies) {
      change += std::abs(from.results[i].impulse[body] - to.results[i].impulse[body]);
    }
    changes.push_back(100 * change / whole);
  }
  return changes;
}

void print_steps(const Study& study, const std::vector<scenes::Hit>& hits) {
  std::printf("\n### Steps: change of the impulses when both steps are halved\n\n");
  std::printf(
      "Of %zu balls; the change is the sum over the bodies of the differences, over the whole.\n\n"
      "| free, contact step | hits | change median | p90 | p95 | steps | us a step | ms a "
      "simulation | a second and core | most steps | messages |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      hits.size());
  const auto runs = static_cast<double>(hits.size());
  for (double free_hz : {60.0, 120.0}) {
    for (double contact_hz : {500.0, 1000.0, 2000.0}) {
      const Outcome here = outcome_of(study, hits, with_steps(free_hz, contact_hz));
      const Outcome half = outcome_of(study, hits, with_steps(2 * free_hz, 2 * contact_hz));
      const auto changes = changes_percent(here, half);
      std::printf(
          "| 1/%.0f, 1/%.0f s | %zu | %.2f %% | %.1f %% | %.1f %% | %.1f | %.0f | %.2f | "
          "%.0f | %d | %d |\n",
          free_hz, contact_hz, changes.size(), quantile(changes, 0.5), quantile(changes, 0.9),
          quantile(changes, 0.95), here.steps / runs, 1e6 * here.cpu_s / here.steps,
          1e3 * here.cpu_s / runs, runs / here.cpu_s, here.most_steps, here.messages);
    }
  }
}

void print_restitution(const Study& study, const std::vector<scenes::Hit>& hits) {
  std::printf("\n### Law: mean impulse of a hit by restitution\n\n");
  std::printf(
      "| restitution | mean impulse, N s | of it beside the part that took most |\n"
      "| --- | --- | --- |\n");
  for (double restitution : {0.5, 0.6, 0.7, 0.8}) {
    std::vector<scenes::Hit> bouncing = hits;
    for (scenes::Hit& hit : bouncing) hit.ball.bounce.restitution = restitution;
    const Outcome outcome = outcome_of(study, bouncing, {});
    double whole = 0;
    double largest = 0;
    double hit = 0;
    for (const auto& result : outcome.results) {
      whole += sum(result.impulse);
      largest += *std::max_element(result.impulse.begin(), result.impulse.end());
      if (sum(result.impulse) > 0) ++hit;
    }
    std::printf("| %.1f | %.2f | %.1f %% |\n", restitution, whole / hit,
                100 * (whole - largest) / whole);
  }
}

void print(const char* title, const Study& study) {
  std::printf("\n## %s: %zu motions\n", title, study.motions.size());
  const auto hits = scenes::random_hits(study.character, study.motions, kHits, 1);
  print_tracking(study);
  print_steps(study, hits);
  print_restitution(study, hits);
}

void run(const bench::StudyArguments& arguments) {
  const motion::Physique man = motion::default_character();
  print("Motions by rule", {man, scenes::motions_by_rule(man.skeleton)});
  if (!arguments.has(0)) return;
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  Study study{library.character, {}};
  for (const motion::Clip& clip : library.clips) study.motions.push_back({clip.name, clip.motion});
  print("The library's clips", study);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"simulation_study [LIBRARY]", 0, 1},
                                   flinch::run);
}
