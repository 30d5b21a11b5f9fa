// SPDX-License-Identifier: MIT
#include "evolve/weakest/weakest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "evolve/weakest/cell_trial.h"
#include "evolve/weakest/clip_genes.h"
#include "train/fit/labels.h"
#include "train/simulate/simulate.h"

namespace flinch::evolve {
namespace {

// Scenarios of a generation. Those of generation k have the numbers from k times this on.
constexpr std::uint64_t kGenerationScenarios = 24;
// Numbers of scenarios that no generation meets: to tell when a run has converged, to choose among
// the best of the last generations, to decide whether to keep the clip, and to measure the gain.
constexpr train::ScenarioRange kCheckScenarios{500'000, 96};
constexpr train::ScenarioRange kChoiceScenarios{1'000'000, 96};
constexpr train::ScenarioRange kKeepScenarios{2'000'000, 192};
constexpr std::uint64_t kFirstFresh = 3'000'000;
constexpr std::size_t kFinalists = 48;
constexpr double kMinGain = 0.01;
constexpr std::uint64_t kCacheBytes = std::uint64_t{1} << 28;

/// What all cells have in common.
struct Mending {
  const WeakestOptions& options;
  const ReportWeakest& report;
  train::SimulationPlan plan;
  train::CostModel cost_model;
  std::vector<CellCost> cells;  ///< the weakest first
};

/// One of the cells.
struct Task {
  const Mending& mending;
  std::size_t number = 0;

  const ThreatCell& cell() const { return mending.cells[number].cell; }
  /// Options with random numbers of its own.
  GeneticOptions genetic() const {
    GeneticOptions options = mending.options.genetic;
    options.seed += number;
    return options;
  }
};

/// Simulates scenarios; nothing if stopped.
std::optional<std::vector<train::Observation>> simulated(const Mending& mending,
                                                         const database::ClipLibrary& library,
                                                         const train::SimulationPlan& plan,
                                                         train::ScenarioRange range) {
  const train::SimulationSetup setup(library, plan);
  train::RehearsalCache rehearsals(kCacheBytes);
  train::BatchContext context;
  context.threads = mending.options.threads;
  context.stop = mending.options.stop;
  train::Batch batch;
  if (!simulate_batch(setup, rehearsals, range, context, batch)) return std::nullopt;
  return std::move(batch.observations);
}

/// A name such as "evolved_head_m45_500ms": the target, the direction in degrees, m for minus, and
/// the least time to impact. A number follows if the library has that already.
std::string clip_name(const Mending& mending, const database::ClipLibrary& library,
                      const ThreatCell& cell) {
  const train::ScenarioDistribution threats = threats_in(mending.plan.distribution, cell).value();
  double least_s = std::numeric_limits<double>::infinity();
  for (const train::ThreatKind& kind : threats.kinds)
    if (kind.weight > 0) least_s = std::min(least_s, kind.time_to_impact_s.min);
  const int degrees = 45 * cell.direction;
  const std::string name = "evolved_" + std::string(motion::name_of(cell.target)) + "_" +
                           (degrees < 0 ? "m" : "") + std::to_string(std::abs(degrees)) + "_" +
                           std::to_string(std::lround(1000 * least_s)) + "ms";
  const auto is_taken = [&](const std::string& candidate) {
    return std::ranges::any_of(library.clips, [&](const motion::Clip& clip) {
      return clip.name == candidate || clip.name == candidate + "_mirrored";
    });
  };
  std::string free = name;
  for (int number = 2; is_taken(free); ++number) free = name + "_" + std::to_string(number);
  return free;
}

/// Goes on with a cell's evolution until it ends. Returns false if stopped.
bool evolve_clips(const Task& task, CellTrial& trial, EvolutionSeries& series) {
  const GeneticOptions genetic = task.genetic();
  Evolution& evolution = series.current;
  if (evolution.chromosomes.empty()) evolution = begin_evolution(genetic, clip_gene_count());
  while (!has_ended(genetic, evolution)) {
    const std::uint64_t first = evolution.history.size() * kGenerationScenarios;
    const auto scores =
        trial.test(evolution.chromosomes, {first, kGenerationScenarios}, task.mending.options.stop);
    if (!scores) return false;
    const auto fitness = [&](std::size_t, std::span<const Chromosome>) {
      std::vector<double> values;
      for (const ClipScore& score : *scores) values.push_back(score.fitness());
      return values;
    };
    const auto check = [&](const Chromosome& best) {
      return trial.test({&best, 1}, kCheckScenarios)->front().fitness();
    };
    advance(genetic, fitness, check, evolution);
    task.mending.report(series, task.mending.cells);
  }
  return true;
}

/// Whether the oracle gains enough by a clip in its cell; nothing if stopped.
std::optional<bool> gains(const Task& task, const database::ClipLibrary& library,
                          const motion::Clip& clip) {
  const Mending& mending = task.mending;
  database::ClipLibrary grown = library;
  add_clip(clip, grown);
  train::SimulationPlan plan = mending.plan;
  plan.distribution = threats_in(mending.plan.distribution, task.cell()).value();
  const auto observations = simulated(mending, grown, plan, kKeepScenarios);
  if (!observations) return std::nullopt;
  const OracleGain gain =
      oracle_gain(*observations, mending.cost_model, static_cast<int>(library.clips.size()), {}, 1);
  return gain.after_ns <= (1 - kMinGain) * gain.before_ns;
}

/// The best clip of a finished evolution that keeps all bounds; nothing if stopped.
std::optional<std::optional<Chromosome>> best_clip(const Task& task,
                                                   const ClipDescription& description,
                                                   CellTrial& trial, const Evolution& evolution) {
  const std::vector<Chromosome> candidates =
      finalists(evolution, task.genetic().window, kFinalists);
  const auto scores = trial.test(candidates, kChoiceScenarios, task.mending.options.stop);
  if (!scores) return std::nullopt;
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return (*scores)[i].fitness(); });
  for (const std::size_t i : order) {
    const EvolvedClip made = trial.clip(candidates[i], description);
    if (made.broken_bounds.empty() &&
        trial.reference_work_j(made.clip) <= task.mending.cost_model.reference_work_j)
      return candidates[i];
  }
  return std::optional<Chromosome>();
}

/// Evolves for a cell, and records what is to be kept. Returns false if stopped.
bool finish_cell(const Task& task, const database::ClipLibrary& library,
                 const ClipDescription& description, CellTrial& trial, EvolutionSeries& series) {
  if (!evolve_clips(task, trial, series)) return false;
  auto best = best_clip(task, description, trial, series.current);
  if (!best) return false;
  if (*best) {
    const auto keeps = gains(task, library, trial.clip(**best, description).clip);
    if (!keeps) return false;
    if (!*keeps) best->reset();
  }
  series.finished.push_back({*best, series.current.history});
  series.current = {};
  task.mending.report(series, task.mending.cells);
  return true;
}

/// Mends one cell, or adds the clip that was found before. Returns the clip's name, empty if there
/// is none, or nothing if stopped.
std::optional<std::string> mend_cell(const Task& task, database::ClipLibrary& library,
                                     EvolutionSeries& series) {
  const Mending& mending = task.mending;
  const ThreatCell& cell = task.cell();
  CellTrial trial({library, mending.plan, mending.cost_model, mending.options.threads}, cell);
  const ClipDescription description{
      clip_name(mending, library, cell), cell.target, cell.azimuth(),
      "evolved, seed " + std::to_string(mending.options.genetic.seed)};
  if (task.number == series.finished.size() &&
      !finish_cell(task, library, description, trial, series))
    return std::nullopt;
  const std::optional<Chromosome>& kept = series.finished[task.number].kept;
  if (!kept) return "";
  const motion::Clip clip = trial.clip(*kept, description).clip;
  add_clip(clip, library);
  return clip.name;
}

Mending mending_of(const WeakestOptions& options, const ReportWeakest& report,
                   const database::ClipLibrary& library) {
  Mending mending{options, report, {}, {}, {}};
  mending.plan.seed = options.genetic.seed;
  mending.cost_model =
      make_cost_model(make_store_header(train::SimulationSetup(library, mending.plan)),
                      options.vulnerability, options.brawn);
  return mending;
}

/// The gain on fresh scenarios; nothing if stopped.
std::optional<MendedLibrary> measure_gain(const Mending& mending,
                                          const database::ClipLibrary& library, int clip_count,
                                          std::span<const std::string> clips) {
  const auto fresh =
      simulated(mending, library, mending.plan, {kFirstFresh, mending.options.scenarios});
  if (!fresh) return std::nullopt;
  const auto gain = [&](std::span<const ThreatCell> cells) {
    return oracle_gain(*fresh, mending.cost_model, clip_count, cells, mending.options.genetic.seed);
  };
  MendedLibrary mended;
  std::vector<ThreatCell> cells;
  for (std::size_t k = 0; k < mending.cells.size(); ++k) {
    cells.push_back(mending.cells[k].cell);
    mended.cells.push_back({mending.cells[k], clips[k], gain({&cells.back(), 1})});
  }
  mended.cells_gain = gain(cells);
  mended.whole_gain = gain({});
  return mended;
}

}  // namespace

std::optional<MendedLibrary> mend_weakest(const WeakestOptions& options,
                                          const ReportWeakest& report,
                                          database::ClipLibrary& library, EvolutionSeries& series) {
  check_options(options.genetic);
  Mending mending = mending_of(options, report, library);
  const auto clip_count = static_cast<int>(library.clips.size());
  const auto found = simulated(mending, library, mending.plan, {0, options.scenarios});
  if (!found) return std::nullopt;
  mending.cells = weakest_cells(cell_costs(*found, mending.cost_model, clip_count), options.cells);
  std::vector<std::string> clips;
  for (std::size_t k = 0; k < mending.cells.size(); ++k) {
    auto clip = mend_cell({mending, k}, library, series);
    if (!clip) return std::nullopt;
    clips.push_back(std::move(*clip));
  }
  return measure_gain(mending, library, clip_count, clips);
}

}  // namespace flinch::evolve
