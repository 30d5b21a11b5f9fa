// SPDX-License-Identifier: MIT
// flinch evolve --weakest.
#include <omp.h>

#include <filesystem>
#include <iostream>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "evolve/run/evolution_file.h"
#include "evolve/weakest/clip_genes.h"
#include "evolve/weakest/weakest.h"
#include "motion/error.h"
#include "program/evolve.h"
#include "program/interrupt.h"
#include "program/printable.h"
#include "program/table.h"
#include "train/evaluate/bins.h"

namespace flinch::program {

namespace {

using evolve::CellCost;
using evolve::EvolutionSeries;
using evolve::MendedCell;
using evolve::MendedLibrary;
using evolve::OracleGain;
using evolve::ThreatCell;

constexpr std::string_view kCellsLogHeader =
    "target,direction_degrees,time_to_impact_s,generation,best_fitness_ns,mean_fitness_ns,"
    "check_fitness_ns";

int direction_degrees(const ThreatCell& cell) {
  return 45 * cell.direction;
}

const char* time_name(const ThreatCell& cell) {
  return train::kTimeBins[static_cast<std::size_t>(cell.time)].name;
}

/// Such as "head, -45 degrees, less than 0.50 s".
std::string name_of(const ThreatCell& cell) {
  return std::string(motion::name_of(cell.target)) + ", " +
         std::to_string(direction_degrees(cell)) + " degrees, " + time_name(cell) + " s";
}

/// Everything that the result depends on, so that a run is only continued by the same command.
std::string key_of(const EvolveOptions& options, const database::ClipLibrary& library,
                   const evolve::WeakestOptions& weakest) {
  const Json key{{"library", database::hash_text(library.hash)},
                 {"laws", sim::kLawVersion},
                 {"weakest", weakest.cells},
                 {"scenarios", weakest.scenarios},
                 {"vulnerability", weakest.vulnerability.vulnerability.values},
                 {"brawn", weakest.brawn},
                 {"population", weakest.genetic.population},
                 {"tournament", weakest.genetic.tournament},
                 {"mutation", options.mutation},
                 {"generations", weakest.genetic.max_generations},
                 {"seed", options.seed}};
  return key.dump();
}

std::string log_lines(const ThreatCell& cell, std::span<const evolve::GenerationRecord> history) {
  std::string lines;
  for (std::size_t k = 0; k < history.size(); ++k)
    lines += std::string(motion::name_of(cell.target)) + "," +
             std::to_string(direction_degrees(cell)) + "," + time_name(cell) + "," +
             std::to_string(k) + "," + fixed(history[k].best_fitness, 6) + "," +
             fixed(history[k].mean_fitness, 6) + "," + fixed(history[k].check_fitness, 6) + "\n";
  return lines;
}

void write_log(const std::string& path, const EvolutionSeries& series,
               std::span<const CellCost> cells) {
  std::string csv = std::string(kCellsLogHeader) + "\n";
  for (std::size_t k = 0; k < series.finished.size(); ++k)
    csv += log_lines(cells[k].cell, series.finished[k].history);
  if (!series.current.history.empty())
    csv += log_lines(cells[series.finished.size()].cell, series.current.history);
  database::write_file_atomically(path, csv);
}

Json to_json(const OracleGain& gain) {
  if (gain.scenarios == 0)
    return {{"scenarios", 0},
            {"cost_before_ns", nullptr},
            {"cost_after_ns", nullptr},
            {"difference_ns", nullptr},
            {"difference_ci_ns", {nullptr, nullptr}}};
  return {
      {"scenarios", gain.scenarios},
      {"cost_before_ns", gain.before_ns},
      {"cost_after_ns", gain.after_ns},
      {"difference_ns", gain.difference_ns.value},
      {"difference_ci_ns", {gain.difference_ns.interval.low, gain.difference_ns.interval.high}}};
}

Json to_json(const MendedCell& cell) {
  return {{"target", motion::name_of(cell.weak.cell.target)},
          {"direction_degrees", direction_degrees(cell.weak.cell)},
          {"time_to_impact_s", time_name(cell.weak.cell)},
          {"found_cost_ns", cell.weak.mean_ns},
          {"clip", cell.clip.empty() ? Json() : Json(cell.clip)},
          {"oracle", to_json(cell.gain)}};
}

/// Such as "12.34 -> 8.90 N s, -27.9 % (2048 scenarios)".
std::string text_of(const OracleGain& gain) {
  if (gain.scenarios == 0)
    return "not measured, no fresh scenario fell into them; raise --scenarios\n";
  const double share = gain.before_ns > 0 ? gain.difference_ns.value / gain.before_ns : 0;
  return fixed(gain.before_ns, 3) + " -> " + fixed(gain.after_ns, 3) + " N s, " +
         fixed(100 * share, 1) + " %, difference " + fixed(gain.difference_ns.interval.low, 3) +
         " to " + fixed(gain.difference_ns.interval.high, 3) + " (" +
         std::to_string(gain.scenarios) + " scenarios)\n";
}

void print_result(const EvolveOptions& options, const database::ClipLibrary& library,
                  const MendedLibrary& mended) {
  if (options.json) {
    Json cells = Json::array();
    for (const MendedCell& cell : mended.cells) cells.push_back(to_json(cell));
    print({{"kind", "evolution"},
           {"file", options.out},
           {"hash", database::hash_text(library.hash)},
           {"clip_count", library.clips.size()},
           {"cells", cells},
           {"cells_oracle", to_json(mended.cells_gain)},
           {"whole_oracle", to_json(mended.whole_gain)}});
    return;
  }
  std::cout << printable(options.out) << ": library " << printable(library.name) << ", "
            << database::hash_text(library.hash) << ", " << library.clips.size() << " clips\n";
  Table table({{"target"},
               {"direction", Table::Align::right},
               {"time to impact, s"},
               {"found, N s", Table::Align::right},
               {"before, N s", Table::Align::right},
               {"after, N s", Table::Align::right},
               {"clip"}});
  for (const MendedCell& cell : mended.cells) {
    const auto fresh = [&](double cost_ns) {
      return cell.gain.scenarios > 0 ? fixed(cost_ns, 3) : "not met";
    };
    table.add({std::string(motion::name_of(cell.weak.cell.target)),
               std::to_string(direction_degrees(cell.weak.cell)), time_name(cell.weak.cell),
               fixed(cell.weak.mean_ns, 3), fresh(cell.gain.before_ns), fresh(cell.gain.after_ns),
               cell.clip.empty() ? "none kept" : cell.clip});
  }
  std::cout << table.text() << "the oracle's cost on fresh scenarios, mean\n  in these cells: "
            << text_of(mended.cells_gain) << "  in all: " << text_of(mended.whole_gain);
}

std::size_t generations_of(const EvolutionSeries& series) {
  std::size_t count = series.current.history.size();
  for (const EvolutionSeries::Finished& run : series.finished) count += run.history.size();
  return count;
}

}  // namespace

void run_evolve_weakest(const EvolveOptions& options) {
  const std::string unfinished = unfinished_file(options);
  check_evolve_outputs(options, kCellsLogHeader);
  evolve::WeakestOptions weakest;
  weakest.cells = static_cast<std::size_t>(*options.weakest);
  weakest.scenarios = options.scenarios;
  weakest.vulnerability = vulnerability_of(options.cost);
  weakest.brawn = options.cost.brawn;
  weakest.genetic = genetic_options(options, weakest.genetic);
  weakest.threads = options.threads.value_or(omp_get_num_procs());
  weakest.stop = &catch_interrupts();
  database::ClipLibrary library = database::load_library(options.library);
  const std::string provenance =
      evolved_provenance(options, evolve::WeakestOptions{}.genetic, library);
  const std::string key = key_of(options, library, weakest);
  EvolutionSeries series =
      evolve::read_evolution(unfinished, key, weakest.genetic.population, evolve::clip_gene_count())
          .value_or(EvolutionSeries{});
  std::optional<MendedLibrary> mended;
  {
    EvolutionDisplay display(options.json);
    const auto report = [&](const EvolutionSeries& now, std::span<const CellCost> cells) {
      evolve::write_evolution(unfinished, key, now);
      if (options.log) write_log(*options.log, now, cells);
      if (now.current.history.empty()) return;
      const std::size_t number = now.finished.size();
      display.show("cell " + std::to_string(number + 1) + " of " + std::to_string(cells.size()) +
                       " (" + name_of(cells[number].cell) + "), ",
                   now.current);
    };
    mended = mend_weakest(weakest, report, library, series);
  }
  if (!mended) throw_interrupted(options, generations_of(series));
  library.provenance = provenance;
  library.hash = database::write_library(library, options.out);
  std::filesystem::remove(unfinished);
  print_result(options, library, *mended);
}

}  // namespace flinch::program
