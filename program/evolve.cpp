// SPDX-License-Identifier: MIT
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "evolve/run/evolution_file.h"
#include "evolve/run/pose_evolution.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/interrupt.h"
#include "program/printable.h"
#include "program/table.h"
#include "program/threat_options.h"

namespace flinch::program {

namespace {

struct EvolveOptions {
  std::string library;
  std::string out;
  std::string target{"head"};
  double azimuth = 0;
  double elevation = 0;
  double speed_mps = 25;
  std::string style{"free"};
  std::uint64_t population = evolve::GeneticOptions{}.population;
  std::uint64_t tournament = evolve::GeneticOptions{}.tournament;
  std::string mutation{"A"};
  std::uint64_t generations = evolve::GeneticOptions{}.max_generations;
  std::uint64_t seed = 1;
  std::optional<std::string> pain;
  std::optional<std::string> log;
  std::optional<int> threads;
  bool force = false;
  bool json = false;
};

constexpr double kTimeToImpact_s = 0.5;
constexpr std::uint64_t kUnseenDraws = 12;  // of 9 balls
constexpr std::string_view kLogHeader =
    "generation,best_fitness_ns,mean_fitness_ns,poses,encounters";

/// Returns the element of `all` with a name that the command line has accepted.
template <class All>
auto named(const All& all, const std::string& name) {
  return *std::ranges::find(all, name, [](auto item) { return std::string(name_of(item)); });
}

template <class All>
std::vector<std::string> names_of(const All& all) {
  std::vector<std::string> names;
  for (const auto item : all) names.emplace_back(name_of(item));
  return names;
}

evolve::GeneticOptions genetic_options(const EvolveOptions& options) {
  evolve::GeneticOptions genetic;
  genetic.population = options.population;
  genetic.tournament = options.tournament;
  genetic.mutation = named(evolve::kMutationSchemes, options.mutation);
  genetic.max_generations = options.generations;
  genetic.seed = options.seed;
  check_options(genetic);
  return genetic;
}

evolve::TrialOptions trial_options(const EvolveOptions& options,
                                   const database::ClipLibrary& library) {
  evolve::TrialOptions trial;
  trial.thrown =
      evolve::throw_at(library.character, library.idle_clip().motion,
                       *motion::target_named(options.target), motion::radians(options.azimuth),
                       motion::radians(options.elevation), options.speed_mps, kTimeToImpact_s);
  trial.style = named(evolve::kStyles, options.style);
  if (options.pain) trial.pain = evolve::read_pain(*options.pain);
  trial.seed = options.seed;
  return trial;
}

/// Everything that the result depends on, so that a run is only continued by the same command.
std::string key_of(const EvolveOptions& options, const database::ClipLibrary& library,
                   const evolve::TrialOptions& trial) {
  const Json key{{"library", database::hash_text(library.hash)},
                 {"laws", sim::kLawVersion},
                 {"target", options.target},
                 {"azimuth", options.azimuth},
                 {"elevation", options.elevation},
                 {"speed", options.speed_mps},
                 {"style", options.style},
                 {"population", options.population},
                 {"tournament", options.tournament},
                 {"mutation", options.mutation},
                 {"seed", options.seed},
                 {"pain", trial.pain.multiplier.values}};
  return key.dump();
}

std::string clip_name(const EvolveOptions& options) {
  std::string azimuth = fixed(options.azimuth, 0);
  std::ranges::replace(azimuth, '-', 'm');
  return "evolved_" + options.target + "_" + azimuth + "_" + options.style;
}

/// Number of encounters that testing this many poses takes.
std::size_t encounters_of(std::size_t poses) {
  return poses * evolve::kJointFailures.size() * evolve::kGridCells;
}

void write_log(const std::string& path, const EvolveOptions& options,
               const evolve::Evolution& evolution) {
  std::string csv = std::string(kLogHeader) + "\n";
  for (std::size_t k = 0; k < evolution.history.size(); ++k) {
    const evolve::GenerationRecord& record = evolution.history[k];
    const std::size_t poses = (k + 1) * options.population;
    csv += std::to_string(k) + "," + fixed(record.best_fitness, 6) + "," +
           fixed(record.mean_fitness, 6) + "," + std::to_string(poses) + "," +
           std::to_string(encounters_of(poses)) + "\n";
  }
  database::write_file_atomically(path, csv);
}

/// A line for each generation; on a terminal they replace each other.
class EvolutionDisplay {
 public:
  explicit EvolutionDisplay(bool json)
      : shows_(!json), terminal_(!json && isatty(STDERR_FILENO) == 1) {}
  EvolutionDisplay(const EvolutionDisplay&) = delete;
  EvolutionDisplay& operator=(const EvolutionDisplay&) = delete;
  ~EvolutionDisplay() {
    if (terminal_ && shown_) std::cerr << std::endl;
  }

  void show(const evolve::Evolution& evolution) {
    if (!shows_) return;
    const evolve::GenerationRecord& last = evolution.history.back();
    std::cerr << (terminal_ ? "\r" : "") << "generation " << evolution.history.size() << ": best "
              << fixed(last.best_fitness, 2) << ", mean " << fixed(last.mean_fitness, 2) << " N s"
              << (terminal_ ? "  " : "\n") << std::flush;
    shown_ = true;
  }

 private:
  bool shows_;
  bool terminal_;
  bool shown_ = false;
};

void print_result(const EvolveOptions& options, const database::ClipLibrary& library,
                  const evolve::PoseTrial& trial, const evolve::Evolution& evolution,
                  const evolve::EvolvedPose& pose, double pain_ns) {
  const double idle_ns = trial.idle_pain();
  const std::size_t poses = evolution.history.size() * options.population;
  const bool converged = has_converged(genetic_options(options), evolution.history);
  if (options.json) {
    print({{"kind", "evolution"},
           {"file", options.out},
           {"hash", database::hash_text(library.hash)},
           {"clip_count", library.clips.size()},
           {"clip", pose.clip.clip.name},
           {"generations", evolution.history.size()},
           {"converged", converged},
           {"poses", poses},
           {"encounters", encounters_of(poses)},
           {"pain_ns", pain_ns},
           {"idle_pain_ns", idle_ns},
           {"pain_share", pain_ns / idle_ns}});
    return;
  }
  std::cout << printable(options.out) << ": library " << printable(library.name) << ", "
            << database::hash_text(library.hash) << ", " << library.clips.size() << " clips\n"
            << pose.clip.clip.name << ", after " << evolution.history.size() << " generations, "
            << (converged ? "converged" : "not converged") << ", " << encounters_of(poses)
            << " encounters\n"
            << "pain of unseen balls: " << fixed(pain_ns, 2) << " N s each, "
            << fixed(100 * pain_ns / idle_ns, 1) << " % of standing still (" << fixed(idle_ns, 2)
            << ")\n";
}

void run_evolve(const EvolveOptions& options) {
  using database::FileKind;
  const std::string unfinished = options.out + ".evolution";
  std::vector<database::Output> outputs{{options.out, FileKind::library, ""},
                                        {unfinished, FileKind::text, evolve::kEvolutionMark}};
  if (options.log) outputs.push_back({*options.log, FileKind::text, kLogHeader});
  database::check_outputs(outputs, {options.library, options.pain.value_or("")},
                          overwrite_of(options.force));
  evolve::PoseEvolution run;
  run.genetic = genetic_options(options);
  run.threads = options.threads.value_or(omp_get_num_procs());
  run.stop = &catch_interrupts();
  database::ClipLibrary library = database::load_library(options.library);
  const evolve::TrialOptions tried = trial_options(options, library);
  const evolve::PoseTrial trial(library.character, library.idle_clip().motion, tried);
  const evolve::ClipDescription description{
      clip_name(options), *motion::target_named(options.target), motion::radians(options.azimuth),
      "evolved, seed " + std::to_string(options.seed)};
  const std::string key = key_of(options, library, tried);
  evolve::Evolution evolution =
      evolve::read_evolution(unfinished, key, options.population, evolve::pose_genes().size())
          .value_or(evolve::Evolution{});
  bool is_whole = false;
  {
    EvolutionDisplay display(options.json);
    run.report = [&](const evolve::Evolution& now) {
      evolve::write_evolution(unfinished, key, now);
      if (options.log) write_log(*options.log, options, now);
      display.show(now);
    };
    is_whole = evolve_poses(trial, run, evolution);
  }
  if (!is_whole)
    throw Error(options.out, "interrupted; " + std::to_string(evolution.history.size()) +
                                 " generations are kept, run the same command again to continue");
  const evolve::EvolvedPose pose =
      chosen_pose(trial, run, evolution, library.idle_clip(), description);
  evolve::add_clip(pose.clip.clip, library);
  library.hash = database::write_library(library, options.out);
  std::filesystem::remove(unfinished);
  const double pain_ns =
      clip_pain(trial, library.idle_clip(), pose.clip.clip, evolve::kUnseenDraw, kUnseenDraws);
  print_result(options, library, trial, evolution, pose, pain_ns);
}

}  // namespace

Command evolve_command() {
  auto options = std::make_shared<EvolveOptions>();
  return {
      .name = "evolve",
      .summary = "Find a pose that protects against a throw by a genetic algorithm",
      .required = {{"LIB", "library to add the pose's clip and its mirror image to",
                    &options->library},
                   {"--out", "library file to write", &options->out}},
      .optional =
          {{"--target", "threatened part: head, trunk, pelvis or legs", &options->target,
            OneOf{target_names()}},
           {"--azimuth", "direction the ball comes from, degrees: 0 the front, 90 the left",
            &options->azimuth, Range{-180, 180}},
           {"--elevation", "angle above the horizontal, degrees", &options->elevation,
            Range{-10, 60}},
           {"--speed", "speed of the ball, m/s", &options->speed_mps, Range{5, 60}},
           {"--style",
            "free; hands: only hands block; near, far: block near the target or far from it",
            &options->style, OneOf{names_of(evolve::kStyles)}},
           {"--population", "poses in a generation, even", &options->population, Range{0, 1e5}},
           {"--tournament", "poses in a tournament, a multiple of 4", &options->tournament,
            Range{0, 1e5}},
           {"--mutation", "mutation scheme of Rose (2006), figure 5.1", &options->mutation,
            OneOf{names_of(evolve::kMutationSchemes)}},
           {"--generations", "maximum number of generations", &options->generations, Range{1, 1e4}},
           {"--seed", "seed of all random numbers", &options->seed},
           {"--pain", "TOML file with how much an impulse hurts at each place", &options->pain},
           {"--log", "CSV file with every generation", &options->log},
           {"--threads", "number of threads (default: one per processor)", &options->threads,
            Range{1, 1024}},
           force_option(options->force),
           json_option(options->json)},
      .notes =
          "After Ctrl-C, run the same command again: whole generations are kept in\n"
          "OUT.evolution until the run is over.\n\n"
          "Example:\n  flinch evolve default.flinchlib --azimuth 30 --style hands --out "
          "evolved.flinchlib --log run.csv",
      .run = [options] { run_evolve(*options); }};
}

}  // namespace flinch::program
