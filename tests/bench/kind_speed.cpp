// SPDX-License-Identifier: MIT
// Prints how fast each kind of threat is simulated, beside the default balls, with the table of
// docs/threats.md:
//
//     kind_speed [THREATS] [SCENARIOS] [RESTING_STEP_MS]
//
// One thread, one run; CPU seconds are those of the simulations after the rehearsals.
#include <cstdio>
#include <string>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/scenes/temporary_folder.h"
#include "train/scenario/threat_file.h"
#include "train/simulate/simulate.h"

namespace flinch {
namespace {

struct Speed {
  double simulations = 0;
  double skipped = 0;
  double hits = 0;
  double steps = 0;
  double cpu_s = 0;  ///< of simulations with a threat
  double rehearsing_s = 0;

  double per_cpu_s() const { return simulations / cpu_s; }
};

Speed speed_of(const database::ClipLibrary& library, const train::SimulationPlan& plan,
               std::uint64_t scenarios) {
  const train::SimulationSetup setup(library, plan);
  train::SimulationRun run;
  run.wanted = {0, scenarios};
  run.batch.threads = 1;
  run.batch.cpu_s = bench::thread_cpu_s;
  run.memory = plan_memory(setup, std::uint64_t{1} << 30, 1);
  train::SimulationProgress last;
  run.report = [&last](const train::SimulationProgress& progress) { last = progress; };
  const tests::TemporaryFolder folder;
  simulate_store(setup, folder / "store", run);
  return {static_cast<double>(last.counts.simulations), static_cast<double>(last.counts.skipped),
          static_cast<double>(last.counts.hits),        static_cast<double>(last.counts.steps),
          last.cpu.contact_s + last.cpu.posing_s,       last.cpu.rehearsing_s};
}

void print(const std::string& name, const Speed& speed, const Speed& balls) {
  std::printf("| %s | %.0f | %.2f | %.1f | %.0f | %.2f | %.2f |\n", name.c_str(), speed.simulations,
              speed.hits / speed.simulations, speed.steps / speed.simulations, speed.per_cpu_s(),
              speed.rehearsing_s, speed.per_cpu_s() / balls.per_cpu_s());
}

void run(const bench::StudyArguments& arguments) {
  const std::string threats = arguments.has(0) ? arguments.text(0) : "kinds";
  const auto scenarios = arguments.number_or<std::uint64_t>(1, 300);
  const database::ClipLibrary library = database::authored_library(motion::default_character());
  train::SimulationPlan plan;
  if (arguments.has(2)) plan.options.resting_step_s = arguments.number<double>(2) / 1e3;
  std::printf(
      "| threat | simulations | hits | steps per simulation | simulations per CPU s | rehearsing, "
      "CPU s | of balls |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  const Speed balls = speed_of(library, plan, scenarios);
  print("balls (the default)", balls, balls);
  const train::ScenarioDistribution all = train::find_threats(threats);
  for (const train::ThreatKind& kind : all.kinds) {
    plan.distribution = all;
    plan.distribution.kinds = {kind};
    print(kind.name, speed_of(library, plan, scenarios), balls);
  }
  plan.distribution = all;
  print("all", speed_of(library, plan, scenarios), balls);
  const Speed again = speed_of(library, {}, scenarios);
  print("balls again", again, balls);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(
      count, arguments, {"kind_speed [THREATS] [SCENARIOS] [RESTING_STEP_MS]", 0, 3}, flinch::run);
}
