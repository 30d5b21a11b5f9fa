// SPDX-License-Identifier: MIT
#include "evolve/weakest/cell_trial.h"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <string>

#include "database/quality/quality.h"
#include "evolve/trial/pose_trial.h"
#include "evolve/weakest/cell_costs.h"
#include "evolve/weakest/clip_genes.h"
#include "runtime/response/response.h"

namespace flinch::evolve {
namespace {

constexpr std::uint64_t kCellCacheBytes = std::uint64_t{1} << 28;
// A clip that breaks a bound loses this share of the cost that the oracle leaves, one that overlaps
// too, and more for each metre.
constexpr double kFlawShare = 0.2;
constexpr double kOverlapShare_per_m = 20;

/// The longest time to a pose: that of the cell's longest time to impact, played as fast as can be.
double longest_move_s(const train::ScenarioDistribution& threats) {
  double longest_s = 0;
  for (const train::ThreatKind& kind : threats.kinds)
    if (kind.weight > 0) longest_s = std::max(longest_s, kind.time_to_impact_s.max);
  return longest_s;
}

train::SimulationPlan plan_in(const train::SimulationPlan& plan, const ThreatCell& cell) {
  train::SimulationPlan part = plan;
  part.distribution = threats_in(plan.distribution, cell).value();
  part.distribution.idle_phase_count = 1;
  return part;
}

train::BatchContext context_of(int threads, const std::atomic<bool>* stop) {
  train::BatchContext context;
  context.threads = threads;
  context.stop = stop;
  return context;
}

}  // namespace

CellTrial::CellTrial(const CellTrialSetup& setup, const ThreatCell& cell)
    : library_(setup.library),
      cell_(cell),
      plan_(plan_in(setup.plan, cell)),
      cost_model_(setup.cost_model),
      threads_(setup.threads),
      figure_(motion::make_figure(setup.library.character)),
      longest_s_(longest_move_s(plan_.distribution)),
      rehearsals_(kCellCacheBytes) {}

PacedPose CellTrial::paced_pose(const Chromosome& chromosome) const {
  return paced_pose_of(figure_, library_.idle_clip().motion.poses.front(), chromosome, longest_s_);
}

EvolvedClip CellTrial::clip(const Chromosome& chromosome,
                            const ClipDescription& description) const {
  return make_evolved_clip(figure_, library_.idle_clip(), paced_pose(chromosome), description);
}

database::ClipLibrary CellTrial::idle_library() const {
  database::ClipLibrary idle;
  idle.name = library_.name;
  idle.character = library_.character;
  idle.rate_hz = library_.rate_hz;
  idle.clips.push_back(library_.idle_clip());
  return idle;
}

double CellTrial::reference_work_j(const motion::Clip& clip) const {
  database::ClipLibrary alone = idle_library();
  alone.clips.push_back(clip);
  return train::reference_work_j(train::SimulationSetup(alone, plan_), 1);
}

std::vector<double> CellTrial::add_clips(std::span<const Chromosome> chromosomes,
                                         database::ClipLibrary& library) const {
  const std::size_t first = library.clips.size();
  library.clips.resize(first + chromosomes.size());
  std::vector<double> flaws(chromosomes.size());
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic) num_threads(threads_)
  for (int k = 0; k < static_cast<int>(chromosomes.size()); ++k) {
    try {
      const auto i = static_cast<std::size_t>(k);
      const PacedPose paced = paced_pose(chromosomes[i]);
      motion::Clip& clip = library.clips[first + i];
      clip = clip_to(figure_, library_.idle_clip(), paced,
                     {std::to_string(i), cell_.target, cell_.azimuth(), ""});
      const double depth_m = overlap_depth_m(figure_, paced.pose);
      flaws[i] = (depth_m > 0 ? kFlawShare + kOverlapShare_per_m * depth_m : 0) +
                 kFlawShare * static_cast<double>(
                                  broken_bounds(database::measure_quality(figure_, clip)).size());
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return flaws;
}

bool CellTrial::know_oracle(train::ScenarioRange range, const std::atomic<bool>* stop) {
  if (oracle_ns_.contains(range.first)) return true;
  if (!setup_) setup_ = std::make_unique<const train::SimulationSetup>(library_, plan_);
  train::Batch batch;
  if (!simulate_batch(*setup_, rehearsals_, range, context_of(threads_, stop), batch)) return false;
  for (const train::Observation& observation : batch.observations)
    oracle_ns_[observation.number] =
        oracle_cost_ns(observation, cost_model_, std::numeric_limits<int>::max());
  return true;
}

std::optional<std::vector<ClipScore>> CellTrial::test(std::span<const Chromosome> chromosomes,
                                                      train::ScenarioRange range,
                                                      const std::atomic<bool>* stop) {
  if (!know_oracle(range, stop)) return std::nullopt;
  database::ClipLibrary candidates = idle_library();
  const std::vector<double> flaws = add_clips(chromosomes, candidates);
  const train::SimulationSetup setup(candidates, plan_);
  train::RehearsalCache none(0);  // each response is tried in one go
  train::Batch batch;
  if (!simulate_batch(setup, none, range, context_of(threads_, stop), batch)) return std::nullopt;
  std::vector<ClipScore> scores(chromosomes.size());
  const auto count = static_cast<double>(range.count);
  double oracle_ns = 0;
  for (const train::Observation& observation : batch.observations) {
    const double best_ns = oracle_ns_.at(observation.number);
    oracle_ns += best_ns / count;
    for (const train::Trial& trial : observation.trials) {
      if (trial.clip == candidates.idle) continue;
      ClipScore& score = scores[static_cast<std::size_t>(trial.clip) - 1];
      const double cost_ns = cost_of(trial, observation.scenario.threat.kind, cost_model_);
      score.cost_ns += cost_ns / count;
      score.oracle_ns += std::min(cost_ns, best_ns) / count;
    }
  }
  for (std::size_t i = 0; i < scores.size(); ++i) scores[i].flaws_ns = flaws[i] * oracle_ns;
  return scores;
}

}  // namespace flinch::evolve
