// SPDX-License-Identifier: MIT
#include "train/simulate.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>

#include "database/library_writer.h"
#include "motion/error.h"
#include "train/program/command.h"
#include "train/program/interrupt.h"
#include "train/program/progress.h"

namespace flinch::train::program {

namespace {

struct Options {
  std::string library;
  std::string store;
  std::uint64_t scenarios = 0;
  std::uint64_t seed = 1;
  int threads = 0;
  bool json = false;
};

int thread_count(const Options& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void print_result(const Options& options, const StoreSummary& store) {
  if (options.json) {
    print({{"kind", "store"},
           {"file", options.store},
           {"scenarios", store.observation_count},
           {"seed", store.header.seed},
           {"library_hash", database::hash_text(store.header.library_hash)}});
    return;
  }
  std::cout << options.store << ": " << store.observation_count << " scenarios of "
            << store.header.library_name << ", seed " << store.header.seed << '\n';
}

void run(const Options& options) {
  const database::Library library = database::load_library(options.library);
  SimulationPlan plan;
  plan.seed = options.seed;
  const SimulationSubject subject(library, plan);
  SimulationProgress last;
  {
    ProgressDisplay display(options.json);
    const bool finished =
        simulate_store(subject, options.store, options.scenarios, thread_count(options),
                       catch_interrupts(), [&](const SimulationProgress& progress) {
                         last = progress;
                         display.show(progress);
                       });
    if (finished) {
      print_result(options, summarise_store(options.store));
      return;
    }
  }
  throw Error(options.store, "interrupted; " + std::to_string(last.scenarios) + " of " +
                                 std::to_string(options.scenarios) +
                                 " scenarios are kept, run the same command again to go on");
}

}  // namespace

void add_simulate(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("simulate", "Try every allowed clip of a library on random scenarios");
  command->add_option("LIB", options->library, "library that flinch import made")->required();
  command->add_option("--out", options->store, "store to write")->required();
  command->add_option("-n", options->scenarios, "number of scenarios")
      ->required()
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  command->add_option("--seed", options->seed, "what the scenarios are drawn from")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "how many (default: one a processor)")
      ->check(CLI::Range(1, 1024));
  add_json_option(*command, options->json);
  command->footer(
      "What is done is kept: after Ctrl-C or a full disk run the same command again, and a\n"
      "finished store goes on when more scenarios are asked for. The same library, seed and\n"
      "number give the same file, byte for byte, on any number of threads.\n\n"
      "Example:\n  flinch simulate real.flinchlib --out real.flinchobs -n 2000 --seed 1");
  command->callback([options] { run(*options); });
}

}  // namespace flinch::train::program
