// SPDX-License-Identifier: MIT
#include "train/simulate/simulate.h"

#include <omp.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <thread>

#include "database/files/file_kind.h"
#include "database/files/library_writer.h"
#include "motion/error.h"
#include "program/clock.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/printable.h"
#include "program/processors.h"
#include "program/progress.h"
#include "program/table.h"
#include "program/unanswered.h"
#include "train/scenario/threat_file.h"
#include "train/simulate/mpi_messenger.h"
#include "train/simulate/worker_pool.h"

namespace flinch::program {

namespace {

struct SimulateOptions {
  std::string library;
  std::string store;
  std::string threats{train::threat_files().front().name};  ///< or a file
  std::vector<std::string> stances;                         ///< NAME or NAME=WEIGHT; or "all"
  std::uint64_t scenarios = 0;
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  std::optional<int> threads;
  std::uint64_t memory = std::uint64_t{1} << 30;
  bool unabridged = false;
  bool places = false;
  std::string figure{"people"};
  bool force = false;
  bool json = false;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
  return text;
}

double weight_of(const std::string& text, const std::string& option) {
  constexpr double kMaxWeight = 1e6;
  double weight = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), weight);
  if (error != std::errc() || end != text.data() + text.size() || !(weight > 0) ||
      weight > kMaxWeight)
    throw UsageError("--stances " + printable(option) + ": a weight is above 0 and at most 1e6");
  return weight;
}

/// Returns the stances that the options name. Throws Error.
std::vector<train::StanceShare> stance_shares(const std::vector<std::string>& texts,
                                              const database::ClipLibrary& library) {
  const std::vector<std::string> names = train::stance_names(library);
  if (texts.empty()) return std::vector<train::StanceShare>(1);
  std::vector<train::StanceShare> shares;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (texts.front() == "all") shares.push_back({static_cast<int>(i), names[i], 1});
  if (!shares.empty() && texts.size() == 1) return shares;
  if (!shares.empty()) throw UsageError("--stances all names every stance; give no other");
  for (const std::string& text : texts) {
    const std::size_t sign = text.rfind('=');
    const std::string name = text.substr(0, sign);
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      throw Error("", "--stances: the library has no stance " + printable(name) + "; it has " +
                          joined(names));
    double weight = 1;
    if (sign != std::string::npos) weight = weight_of(text.substr(sign + 1), text);
    const auto stance = static_cast<int>(found - names.begin());
    if (std::ranges::find(shares, stance, &train::StanceShare::stance) != shares.end())
      throw UsageError("--stances names " + printable(name) + " twice");
    shares.push_back({stance, name, weight});
  }
  return shares;
}

/// Returns the number of processors for this process: those that it may use, shared with the run's
/// other processes on this machine.
int thread_count(const SimulateOptions& options, const train::Messenger& messenger) {
  if (options.threads) return *options.threads;
  const auto share = static_cast<int>(std::thread::hardware_concurrency()) / messenger.local_size();
  return std::clamp(share, 1, std::max(1, omp_get_num_procs()));
}

/// Tells of a launcher that leaves the run's threads too few processors. The store is the same, but
/// takes that much longer.
void print_binding_note(const SimulateOptions& options, const train::Messenger& messenger) {
  const std::string note =
      binding_note(count_processors(), options.threads, messenger.local_size());
  if (!note.empty()) log_note(note);
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

/// Prints what the run will use, before it starts.
void print_plan(const train::SimulationRun& run) {
  const train::MemoryPlan& memory = run.memory;
  std::ostringstream text;
  text << "memory: at most " << mebibytes(memory.max_bytes)
       << (run.messenger->size() > 1 ? " per process" : "") << "; " << memory.response_count
       << " different responses need about " << mebibytes(memory.all_response_bytes)
       << ", of which " << (memory.keeps_all() ? "all" : mebibytes(memory.response_bytes))
       << " is kept for all batches of up to " << memory.batch_size << " scenarios per thread";
  log(LogLevel::info, text.str());
}

Json summary_document(const SimulateOptions& options, const train::StoreSummary& store,
                      const train::SimulationProgress& done) {
  const train::SimulationCounts& counts = done.counts;
  return {{"kind", "store"},
          {"file", options.store},
          {"first", store.range.first},
          {"scenarios", store.observation_count},
          {"seed", store.header.seed},
          {"library_hash", database::hash_text(store.header.library_hash)},
          {"simulations", counts.simulations},
          {"skipped", counts.skipped},
          {"hits", counts.hits},
          {"steps", counts.steps},
          {"solver_messages", counts.solver_messages},
          {"unanswered", unanswered(store.header.clips)},
          {"cpu_s",
           {{"posing", done.cpu.posing_s},
            {"rehearsing", done.cpu.rehearsing_s},
            {"striking", done.cpu.contact_s},
            {"writing", done.cpu.writing_s}}}};
}

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

void print_summary(const train::SimulationProgress& done) {
  const train::SimulationCounts& counts = done.counts;
  const train::PhaseTimes& cpu = done.cpu;
  const auto simulations = static_cast<double>(counts.simulations);
  std::cout << "simulations: " << counts.simulations << ", "
            << fixed(100 * ratio(static_cast<double>(counts.hits), simulations), 1)
            << " % with contact, "
            << fixed(100 * ratio(static_cast<double>(counts.skipped), simulations), 1)
            << " % skipped because nothing could touch\n"
            << "solver messages: "
            << fixed(1000 * ratio(static_cast<double>(counts.solver_messages),
                                  static_cast<double>(counts.steps)),
                     3)
            << " per 1000 of " << counts.steps << " steps\n"
            << "CPU time: " << fixed(cpu.total_s(), 1) << " s (posing " << fixed(cpu.posing_s, 1)
            << ", rehearsing " << fixed(cpu.rehearsing_s, 1) << ", striking "
            << fixed(cpu.contact_s, 1) << ", writing " << fixed(cpu.writing_s, 1) << "), "
            << fixed(ratio(simulations, cpu.total_s()), 0) << " simulations per CPU second\n";
}

void print_result(const SimulateOptions& options, const train::SimulationProgress& done) {
  const train::StoreSummary store = train::summarise_store(options.store);
  if (options.json) {
    print_line(summary_document(options, store, done));
    return;
  }
  std::cout << printable(options.store) << ": " << store.observation_count << " scenarios of "
            << printable(store.header.library_name);
  if (store.range.first > 0) std::cout << " from number " << store.range.first;
  std::cout << ", seed " << store.header.seed << '\n';
  if (done.counts.simulations > 0) print_summary(done);
  for (const std::string& line : unanswered(store.header.clips)) log_note(line);
}

void write_store(const SimulateOptions& options, const train::SimulationSetup& setup,
                 train::SimulationRun& run) {
  train::SimulationProgress last;
  {
    ProgressDisplay display(options.json);
    run.report = [&](const train::SimulationProgress& progress) {
      const bool begins = last.wanted == 0;
      if (begins && !options.json) print_plan(run);
      last = progress;
      display.show(progress);
    };
    if (train::simulate_store(setup, options.store, run)) {
      print_result(options, last);
      return;
    }
  }
  throw Error(options.store, "interrupted; " + std::to_string(last.scenarios) + " of " +
                                 std::to_string(last.wanted) +
                                 " scenarios are kept, run the same command again to continue");
}

void simulate(const SimulateOptions& options, train::Messenger& messenger) {
  if (messenger.rank() == 0) {
    const std::string threat_file =
        database::names_toml_file(options.threats) ? options.threats : "";
    database::check_outputs({train::store_output(options.store)}, {options.library, threat_file},
                            overwrite_of(options.force));
  }
  train::SimulationPlan plan;
  plan.distribution = train::find_threats(options.threats);
  plan.threats = options.threats;
  const database::ClipLibrary library = database::load_library(options.library);
  plan.distribution.stances = stance_shares(options.stances, library);
  plan.seed = options.seed;
  plan.unabridged = options.unabridged;
  plan.options.keeps_places = options.places;
  plan.options.figure = figure_of(options.figure);
  const train::SimulationSetup setup(library, plan);
  train::SimulationRun run;
  run.wanted = {options.first, options.scenarios};
  run.batch.threads = thread_count(options, messenger);
  run.batch.cpu_s = thread_cpu_s;
  run.batch.stop = &catch_interrupts();
  run.memory = train::plan_memory(setup, options.memory, run.batch.threads);
  run.messenger = &messenger;
  run.overwrite = overwrite_of(options.force);
  if (messenger.rank() == 0) {
    print_binding_note(options, messenger);
    write_store(options, setup, run);
  } else {
    run_simulation_worker(setup, run);
  }
}

void run_simulate(const SimulateOptions& options) {
  const std::unique_ptr<train::Messenger> messenger = train::make_messenger();
  if (messenger->rank() == 0) {
    simulate(options, *messenger);
    return;
  }
  // Prints one line with the error, by process 0 only.
  try {
    simulate(options, *messenger);
  } catch (const std::exception& error) {
    report_failure(*messenger, error.what());
  }
}

}  // namespace

Command simulate_command() {
  auto options = std::make_shared<SimulateOptions>();
  return {
      .name = "simulate",
      .summary = "Try every allowed clip of a library on random scenarios",
      .required = {{"LIB", "library made by flinch author or import", &options->library},
                   {"--out", "store file to write", &options->store},
                   {"-n", "number of scenarios", &options->scenarios, Range{1, 1e9}}},
      .optional =
          {{"--threats", "what is thrown (docs/threats.md; flinch threats prints the shipped ones)",
            &options->threats, OneOfOrFile{threat_file_names(), ".toml"}},
           {"--stances",
            "stances in which characters perceive, each NAME or NAME=WEIGHT, or all (default: the "
            "idle clip)",
            &options->stances},
           {"--first", "number of the first scenario, for one of several stores to merge",
            &options->first},
           {"--seed", "seed of the random scenarios", &options->seed},
           threads_option(options->threads),
           {"--memory", "maximum memory to use, such as 512M or 2G", &options->memory, ByteCount{}},
           {"--reference", "simulate each trial separately from perception on: many times slower",
            &options->unabridged},
           {"--places", "also keep where bodies are hit, for --pain of train, compare and export",
            &options->places},
           figure_option(options->figure),
           force_option(options->force),
           {"--json", "print lines of JSON and nothing else: progress, and a summary at the end",
            &options->json}},
      .notes =
          "Finished work is kept: after Ctrl-C or a full disk, run the same command again. Ask "
          "for\n"
          "more scenarios to continue a finished store. The same library, seed and scenario\n"
          "numbers give the same file, byte for byte, on any number of threads, with any memory, "
          "and\n"
          "by any number of processes that mpirun starts.\n\n"
          "Example:\n  flinch simulate real.flinchlib --out real.flinchobs -n 2000 --seed 1\n\n"
          "On a cluster:\n"
          "  mpirun -n 64 --bind-to none flinch simulate real.flinchlib --out real.flinchobs "
          "-n 1000000",
      .run = [options] { run_simulate(*options); }};
}

}  // namespace flinch::program
