// SPDX-License-Identifier: MIT
// flinch evolve for one throw.
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "evolve/run/evolution_file.h"
#include "evolve/run/pose_evolution.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/evolve.h"
#include "program/interrupt.h"
#include "program/printable.h"
#include "program/table.h"

namespace flinch::program {

namespace {

constexpr double kTimeToImpact_s = 0.5;
constexpr std::uint64_t kUnseenDraws = 12;  // of 9 balls
constexpr std::string_view kLogHeader =
    "generation,best_fitness_ns,mean_fitness_ns,check_fitness_ns,poses,encounters";

/// Number of encounters that testing this many poses takes.
std::size_t encounters_of(std::size_t poses) {
  return poses * evolve::kJointFailures.size() * evolve::kGridCells;
}

void write_log(const std::string& path, std::size_t population,
               const evolve::Evolution& evolution) {
  std::string csv = std::string(kLogHeader) + "\n";
  for (std::size_t k = 0; k < evolution.history.size(); ++k) {
    const evolve::GenerationRecord& record = evolution.history[k];
    const std::size_t poses = (k + 1) * population;
    csv += std::to_string(k) + "," + fixed(record.best_fitness, 6) + "," +
           fixed(record.mean_fitness, 6) + "," + fixed(record.check_fitness, 6) + "," +
           std::to_string(poses) + "," + std::to_string(encounters_of(poses)) + "\n";
  }
  database::write_file_atomically(path, csv);
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
  trial.gene_map = named(evolve::kGeneMaps, options.gene_map);
  trial.simulation.figure = figure_of(options.figure);
  trial.are_limp = options.failed_joints == "limp";
  trial.limit_weight_per_rads = options.limit_weight;
  trial.extension_weight = options.extension_weight;
  trial.seed = options.seed;
  return trial;
}

/// Everything that the result depends on, so that a run is only continued by the same command.
std::string key_of(const EvolveOptions& options, const database::ClipLibrary& library,
                   const evolve::GeneticOptions& genetic, const evolve::TrialOptions& trial) {
  const Json key{{"library", database::hash_text(library.hash)},
                 {"laws", sim::kLawVersion},
                 {"target", options.target},
                 {"azimuth", options.azimuth},
                 {"elevation", options.elevation},
                 {"speed", options.speed_mps},
                 {"style", options.style},
                 {"population", genetic.population},
                 {"tournament", options.tournament},
                 {"mutation", options.mutation},
                 {"gene_map", options.gene_map},
                 {"seed", options.seed},
                 {"figure", options.figure},
                 {"failed_joints", options.failed_joints},
                 {"limit_weight", options.limit_weight},
                 {"extension_weight", options.extension_weight},
                 {"pain", trial.pain.multiplier.values}};
  return key.dump();
}

std::string clip_name(const EvolveOptions& options) {
  std::string azimuth = fixed(options.azimuth, 0);
  std::ranges::replace(azimuth, '-', 'm');
  return "evolved_" + options.target + "_" + azimuth + "_" + options.style;
}

void print_result(const EvolveOptions& options, const database::ClipLibrary& library,
                  const evolve::GeneticOptions& genetic, const evolve::PoseTrial& trial,
                  const evolve::Evolution& evolution, const evolve::EvolvedPose& pose,
                  double pain_ns) {
  const double idle_ns = trial.idle_pain();
  const std::size_t poses = evolution.history.size() * genetic.population;
  const bool converged = has_converged(genetic, evolution.history);
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

}  // namespace

void run_evolve_throw(const EvolveOptions& options) {
  const std::string unfinished = unfinished_file(options);
  check_evolve_outputs(options, kLogHeader);
  evolve::PoseEvolution run;
  run.genetic = genetic_options(options, {});
  run.threads = options.threads.value_or(omp_get_num_procs());
  run.stop = &catch_interrupts();
  database::ClipLibrary library = database::load_library(options.library);
  const std::string provenance = evolved_provenance(options, {}, library);
  const evolve::TrialOptions tried = trial_options(options, library);
  const evolve::PoseTrial trial(library.character, library.idle_clip().motion, tried);
  if (!(trial.idle_pain() > 0))
    throw Error(options.library,
                "standing still does not hurt, so no pose can hurt less; give another --target or "
                "--pain");
  const evolve::ClipDescription description{
      clip_name(options), *motion::target_named(options.target), motion::radians(options.azimuth),
      "evolved, seed " + std::to_string(options.seed)};
  const std::string key = key_of(options, library, run.genetic, tried);
  evolve::EvolutionSeries series =
      evolve::read_evolution(unfinished, key, run.genetic.population, trial.genes().size())
          .value_or(evolve::EvolutionSeries{});
  evolve::Evolution& evolution = series.current;
  bool is_whole = false;
  {
    EvolutionDisplay display(options.json);
    run.report = [&](const evolve::Evolution& now) {
      evolve::write_evolution(unfinished, key, series);
      if (options.log) write_log(*options.log, run.genetic.population, now);
      display.show("", now);
    };
    is_whole = evolve_poses(trial, run, evolution);
  }
  if (!is_whole) throw_interrupted(options, evolution.history.size());
  const evolve::EvolvedPose pose =
      chosen_pose(trial, run, evolution, library.idle_clip(), description);
  evolve::add_clip(pose.clip.clip, library);
  library.provenance = provenance;
  library.hash = database::write_library(library, options.out);
  std::filesystem::remove(unfinished);
  const double pain_ns =
      clip_pain(trial, library.idle_clip(), pose.clip.clip, evolve::kUnseenDraw, kUnseenDraws);
  print_result(options, library, run.genetic, trial, evolution, pose, pain_ns);
}

}  // namespace flinch::program
