// SPDX-License-Identifier: MIT
#include "program/evolve.h"
#include "program/command_line.h"

#include <iostream>
#include <memory>

#include "database/files/provenance.h"
#include "evolve/run/evolution_file.h"
#include "evolve/trial/pose_trial.h"
#include "motion/error.h"
#include "program/command_line.h"
#include "program/threat_options.h"
#include "train/report/cost_provenance.h"

namespace flinch::program {

namespace {

template <class All>
std::vector<std::string> names_of(const All& all) {
  std::vector<std::string> names;
  for (const auto item : all) names.emplace_back(name_of(item));
  return names;
}

/// Refuses options of --weakest beside one throw.
void check_throw(const EvolveOptions& options) {
  const EvolveOptions defaults;
  const auto refuse = [](bool is_given, const std::string& name) {
    if (is_given) throw UsageError(name + " is for --weakest; leave it out");
  };
  refuse(options.scenarios != defaults.scenarios, "--scenarios");
  refuse(options.cost.brawn != defaults.cost.brawn, "--brawn");
  refuse(options.cost.vulnerability != defaults.cost.vulnerability, "--vulnerability");
}

/// Refuses options of one throw beside --weakest, which finds its own.
void check_weakest(const EvolveOptions& options) {
  const EvolveOptions defaults;
  const auto refuse = [](bool is_given, const std::string& name) {
    if (is_given) throw UsageError("--weakest finds the threats itself; leave out " + name);
  };
  refuse(options.target != defaults.target, "--target");
  refuse(options.azimuth != defaults.azimuth, "--azimuth");
  refuse(options.elevation != defaults.elevation, "--elevation");
  refuse(options.speed_mps != defaults.speed_mps, "--speed");
  refuse(options.style != defaults.style, "--style");
  refuse(options.pain.has_value(), "--pain");
  refuse(options.figure != defaults.figure, "--figure");
  refuse(options.gene_map != defaults.gene_map, "--gene-map");
  refuse(options.failed_joints != defaults.failed_joints, "--failed-joints");
  refuse(options.limit_weight != defaults.limit_weight, "--limit-weight");
  refuse(options.extension_weight != defaults.extension_weight, "--extension-weight");
}

void run_evolve(const EvolveOptions& options) {
  if (!options.weakest) {
    check_throw(options);
    run_evolve_throw(options);
    return;
  }
  check_weakest(options);
  run_evolve_weakest(options);
}

}  // namespace

evolve::GeneticOptions genetic_options(const EvolveOptions& options,
                                       evolve::GeneticOptions genetic) {
  if (options.population) genetic.population = static_cast<std::size_t>(*options.population);
  genetic.tournament = options.tournament;
  genetic.mutation = named(evolve::kMutationSchemes, options.mutation);
  if (options.generations) genetic.max_generations = static_cast<std::size_t>(*options.generations);
  genetic.seed = options.seed;
  check_options(genetic);
  return genetic;
}

std::string unfinished_file(const EvolveOptions& options) {
  return options.out + ".evolution";
}

void check_evolve_outputs(const EvolveOptions& options, std::string_view log_header) {
  using database::FileKind;
  std::vector<database::Output> outputs{
      {options.out, FileKind::library, ""},
      {unfinished_file(options), FileKind::text, evolve::kEvolutionMark}};
  if (options.log) outputs.push_back({*options.log, FileKind::text, log_header});
  database::check_outputs(
      outputs, {options.library, options.pain.value_or(""), vulnerability_file(options.cost)},
      overwrite_of(options.force));
}

std::string evolved_provenance(const EvolveOptions& options, const evolve::GeneticOptions& defaults,
                               const database::ClipLibrary& from) {
  const EvolveOptions usual;
  const evolve::GeneticOptions genetic = genetic_options(options, defaults);
  database::Provenance made{.command = "evolve", .seed = options.seed};
  made.inputs.push_back({"library", "", from.hash, from.provenance});
  add_option("weakest", options.weakest, made);
  add_option("scenarios", options.scenarios, usual.scenarios, made);
  train::add_cost_options({options.cost.brawn, options.cost.vulnerability, {}}, made);
  add_option("target", options.target, usual.target, made);
  add_option("azimuth", options.azimuth, usual.azimuth, made);
  add_option("elevation", options.elevation, usual.elevation, made);
  add_option("speed", options.speed_mps, usual.speed_mps, made);
  add_option("style", options.style, usual.style, made);
  add_option("population", genetic.population, defaults.population, made);
  add_option("tournament", options.tournament, usual.tournament, made);
  add_option("mutation", options.mutation, usual.mutation, made);
  add_option("gene-map", options.gene_map, usual.gene_map, made);
  add_option("generations", genetic.max_generations, defaults.max_generations, made);
  if (options.pain) add_inputs("pain", {*options.pain}, made);
  add_option("figure", options.figure, usual.figure, made);
  add_option("failed-joints", options.failed_joints, usual.failed_joints, made);
  add_option("limit-weight", options.limit_weight, usual.limit_weight, made);
  add_option("extension-weight", options.extension_weight, usual.extension_weight, made);
  return database::provenance_text(made);
}

void throw_interrupted(const EvolveOptions& options, std::size_t generations) {
  throw Error(options.out, "interrupted; " + std::to_string(generations) +
                               " generations are kept, run the same command again to continue");
}

Command evolve_command() {
  auto options = std::make_shared<EvolveOptions>();
  return {
      .name = "evolve",
      .summary = "Find poses that protect, by a genetic algorithm",
      .required = {{"LIB", "library to add clips and their mirror images to", &options->library},
                   {"--out", "library file to write", &options->out}},
      .optional = join(
          {{{"--weakest",
             "find this many cells of target, direction and time to impact in which the library "
             "protects worst, and evolve for each in place of one throw",
             &options->weakest, Range{1, 128}},
            {"--scenarios",
             "of --weakest: scenarios to find the cells with, and as many fresh "
             "ones to measure the gain",
             &options->scenarios, Range{1, 1e7}}},
           cost_options(options->cost),
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
            {"--population", "poses in a generation, even (default: 400; of --weakest 96)",
             &options->population, Range{0, 1e5}},
            {"--tournament", "poses in a tournament, a multiple of 4", &options->tournament,
             Range{0, 1e5}},
            {"--mutation", "mutation scheme of Rose (2006), figure 5.1", &options->mutation,
             OneOf{names_of(evolve::kMutationSchemes)}},
            {"--gene-map",
             "what a gene stands for: an angle within the joint's limits, or of a full turn, held "
             "at the limits",
             &options->gene_map, OneOf{names_of(evolve::kGeneMaps)}},
            {"--generations", "maximum number of generations (default: 60; of --weakest 20)",
             &options->generations, Range{1, 1e4}},
            {"--seed", "seed of all random numbers", &options->seed},
            {"--pain", "TOML file with how much an impulse hurts at each place", &options->pain},
            figure_option(options->figure),
            {"--failed-joints",
             "what a shoulder does that fails in the test: idle on, or hang limp",
             &options->failed_joints, OneOf{{"idle", "limp"}}},
            {"--limit-weight",
             "what a radian second beyond the limits of struck joints costs, in shares of the pain "
             "of standing still",
             &options->limit_weight, Range{0, 1000}},
            {"--extension-weight",
             "how much more energy torque takes that pulls the back of a hand",
             &options->extension_weight, Range{0, 1000}},
            {"--log", "CSV file with every generation", &options->log},
            threads_option(options->threads),
            force_option(options->force),
            json_option(options->json)}}),
      .notes =
          "After Ctrl-C, run the same command again: whole generations are kept in\n"
          "OUT.evolution until the run is over.\n\n"
          "Example:\n  flinch evolve default.flinchlib --azimuth 30 --style hands --out "
          "evolved.flinchlib --log run.csv\n  flinch evolve default.flinchlib --weakest 8 --out "
          "evolved.flinchlib",
      .run = [options] { run_evolve(*options); }};
}

}  // namespace flinch::program
