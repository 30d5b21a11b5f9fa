// SPDX-License-Identifier: MIT
#include "evolve/run/pose_evolution.h"

#include <algorithm>
#include <numeric>

#include "motion/error.h"

namespace flinch::evolve {
namespace {

constexpr std::uint64_t kCheckDraws = 4;
constexpr std::uint64_t kChoiceDraws = 4;
constexpr std::size_t kChoices = 64;

/// Returns the mean scores over `draws` draws from `first` on.
std::vector<PoseScore> mean_scores(const PoseTrial& trial, std::span<const Chromosome> candidates,
                                   std::uint64_t first, std::uint64_t draws, int threads,
                                   RehearsedPoses& remembered) {
  std::vector<PoseScore> sums(candidates.size());
  const auto count = static_cast<double>(draws);
  for (std::uint64_t draw = first; draw < first + draws; ++draw) {
    const std::vector<PoseScore> scores =
        *trial.test(candidates, draw, threads, nullptr, &remembered);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].pain += scores[i].pain / count;
      sums[i].energy += scores[i].energy / count;
      sums[i].distance += scores[i].distance / count;
      sums[i].overlap += scores[i].overlap / count;
      sums[i].limits += scores[i].limits / count;
    }
  }
  return sums;
}

}  // namespace

bool evolve_poses(const PoseTrial& trial, const PoseEvolution& run, Evolution& evolution) {
  GeneticOptions genetic = run.genetic;
  genetic.ends = ends_of(trial.options().gene_map);
  if (evolution.chromosomes.empty()) evolution = begin_evolution(genetic, trial.genes().size());
  RehearsedPoses remembered;
  while (!has_ended(genetic, evolution)) {
    // A generation that is stopped is not recorded.
    const auto scores = trial.test(evolution.chromosomes, evolution.history.size(), run.threads,
                                   run.stop, &remembered);
    if (!scores) return false;
    const auto fitness = [&](std::size_t, std::span<const Chromosome>) {
      std::vector<double> values;
      for (const PoseScore& score : *scores) values.push_back(score.fitness());
      return values;
    };
    const auto check = [&](const Chromosome& best) {
      return mean_scores(trial, {&best, 1}, kCheckDraw, kCheckDraws, 1, remembered)
          .front()
          .fitness();
    };
    advance(genetic, fitness, check, evolution);
    remembered.keep_only(evolution.chromosomes);
    run.report(evolution);
  }
  return true;
}

EvolvedPose chosen_pose(const PoseTrial& trial, const PoseEvolution& run,
                        const Evolution& evolution, const motion::Clip& idle,
                        const ClipDescription& description) {
  const std::vector<Chromosome> candidates = finalists(evolution, run.genetic.window, kChoices);
  RehearsedPoses remembered;
  const std::vector<PoseScore> scores =
      mean_scores(trial, candidates, kChoiceDraw, kChoiceDraws, run.threads, remembered);
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return scores[i].fitness(); });
  std::string broken;
  for (const std::size_t i : order) {
    const motion::Pose pose = trial.pose(candidates[i]);
    const PacedPose paced{pose, move_time_s(trial.figure(), trial.start(), pose)};
    EvolvedPose chosen{candidates[i], scores[i],
                       make_evolved_clip(trial.figure(), idle, paced, description)};
    if (chosen.clip.broken_bounds.empty()) return chosen;
    if (broken.empty()) broken = chosen.clip.broken_bounds.front();
  }
  throw Error("",
              "no evolved pose becomes a clip that keeps the bounds of `flinch info --quality`; "
              "the best breaks " +
                  broken + "; try another --seed or a larger --population");
}

}  // namespace flinch::evolve
