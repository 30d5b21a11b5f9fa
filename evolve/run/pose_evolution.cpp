// SPDX-License-Identifier: MIT
#include "evolve/run/pose_evolution.h"

#include <algorithm>
#include <numeric>

#include "motion/error.h"

namespace flinch::evolve {
namespace {

constexpr std::uint64_t kChoiceDraws = 4;
constexpr std::size_t kChoices = 64;

/// Returns the mean scores over the draws that a pose is chosen by.
std::vector<PoseScore> scores_of(const PoseTrial& trial, std::span<const Chromosome> candidates,
                                 int threads) {
  std::vector<PoseScore> sums(candidates.size());
  for (std::uint64_t draw = 0; draw < kChoiceDraws; ++draw) {
    const std::vector<PoseScore> scores = *trial.test(candidates, kChoiceDraw + draw, threads);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].pain += scores[i].pain / kChoiceDraws;
      sums[i].energy += scores[i].energy / kChoiceDraws;
      sums[i].distance += scores[i].distance / kChoiceDraws;
      sums[i].overlap += scores[i].overlap / kChoiceDraws;
    }
  }
  return sums;
}

/// The best of the last generations, and as many of the next generation as there is room for:
/// among them are the winners of the last.
std::vector<Chromosome> candidates_of(const Evolution& evolution, std::size_t window) {
  std::vector<Chromosome> candidates;
  const auto add = [&](const Chromosome& chromosome) {
    if (candidates.size() < kChoices &&
        std::ranges::find(candidates, chromosome) == candidates.end())
      candidates.push_back(chromosome);
  };
  const std::size_t recent = std::min(window, evolution.history.size());
  for (std::size_t k = 0; k < recent; ++k)
    add(evolution.history[evolution.history.size() - 1 - k].best);
  for (const Chromosome& chromosome : evolution.chromosomes) add(chromosome);
  return candidates;
}

}  // namespace

bool evolve_poses(const PoseTrial& trial, const PoseEvolution& run, Evolution& evolution) {
  if (evolution.chromosomes.empty()) evolution = begin_evolution(run.genetic, pose_genes().size());
  while (!has_ended(run.genetic, evolution)) {
    // A generation that is stopped is not recorded.
    const auto scores =
        trial.test(evolution.chromosomes, evolution.history.size(), run.threads, run.stop);
    if (!scores) return false;
    const auto fitness = [&](std::size_t, std::span<const Chromosome>) {
      std::vector<double> values;
      for (const PoseScore& score : *scores) values.push_back(score.fitness());
      return values;
    };
    advance(run.genetic, fitness, evolution);
    run.report(evolution);
  }
  return true;
}

EvolvedPose chosen_pose(const PoseTrial& trial, const PoseEvolution& run,
                        const Evolution& evolution, const motion::Clip& idle,
                        const ClipDescription& description) {
  const std::vector<Chromosome> candidates = candidates_of(evolution, run.genetic.window);
  const std::vector<PoseScore> scores = scores_of(trial, candidates, run.threads);
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return scores[i].fitness(); });
  std::string broken;
  for (const std::size_t i : order) {
    EvolvedPose chosen{candidates[i], scores[i],
                       make_evolved_clip(trial, idle, trial.pose(candidates[i]), description)};
    if (chosen.clip.broken_bounds.empty()) return chosen;
    if (broken.empty()) broken = chosen.clip.broken_bounds.front();
  }
  throw Error("",
              "no evolved pose becomes a clip that keeps the bounds of `flinch info --quality`; "
              "the best breaks " +
                  broken + "; try another --seed or a larger --population");
}

}  // namespace flinch::evolve
