// SPDX-License-Identifier: MIT
#include "models/fit/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "models/fit/fold_splits.h"
#include "models/fit/parallel_for.h"
#include "models/selector.h"
#include "motion/error.h"

namespace flinch::models {
namespace {

/// Number of parameter sets that are tried on all folds.
constexpr std::size_t kFinalists = 3;

/// Number of held-out observations that is enough to compare models.
constexpr int kEnough = 1500;

/// The clip that each parameter set chooses for each held-out observation: one row of set.size()
/// clips per parameter set.
using Choices = std::vector<std::vector<int>>;

Choices no_choices(const TrainingSet& set, std::size_t rows) {
  return Choices(rows, std::vector<int>(set.label.size()));
}

/// Finds neighbours of held-out observations among a training set's allowed ones; one kd-tree per
/// mask.
class MaskedNeighbours {
 public:
  explicit MaskedNeighbours(const TrainingSet& set) {
    for (const ClipMask& mask : set.masks) {
      std::vector<int> rows;
      for (int i = 0; i < set.size(); ++i) {
        if (mask[static_cast<std::size_t>(set.label[static_cast<std::size_t>(i)])]) {
          rows.push_back(i);
        }
      }
      TrainingSet allowed = subset(set, rows);
      labels_.push_back(std::move(allowed.label));
      trees_.emplace_back(allowed.points, set.feature_count);
    }
  }

  std::vector<Neighbour> nearest(int mask, std::span<const double> scaled, int k) const {
    return trees_[static_cast<std::size_t>(mask)].nearest(scaled, k);
  }
  std::span<const int> labels(int mask) const { return labels_[static_cast<std::size_t>(mask)]; }

 private:
  std::vector<std::vector<int>> labels_;
  std::vector<NeighbourIndex> trees_;
};

bool averages_costs(const KnnParameters& parameters) {
  return parameters.vote == KnnVote::cost;
}

/// Sets the choices of every parameter set of the grid for one fold's observations. The largest
/// number of neighbours that any of them needs is searched once, among the allowed observations for
/// votes and among all for costs.
void choose_for_fold(const TrainingSet& set, std::span<const KnnParameters> grid,
                     const FoldSplit& split, Choices& choices) {
  int max_k = 0;
  for (const KnnParameters& parameters : grid) {
    max_k = std::max(max_k, parameters.k);
  }
  const bool any_averages = std::any_of(grid.begin(), grid.end(), averages_costs);
  const bool all_average = std::all_of(grid.begin(), grid.end(), averages_costs);
  std::optional<MaskedNeighbours> by_label;
  if (!all_average) {
    by_label.emplace(split.training);
  }
  const auto by_cost = any_averages ? fit_knn(split.training, {max_k, KnnVote::cost}) : KnnModel();
  for (const int observation : split.held_out) {
    const auto i = static_cast<std::size_t>(observation);
    const std::span<const double> point = set.point(observation);
    const auto allowed =
        all_average ? std::vector<Neighbour>() : by_label->nearest(set.mask[i], point, max_k);
    const auto all = nearest(by_cost, point, any_averages ? max_k : 0, {});
    for (std::size_t row = 0; row < grid.size(); ++row) {
      const auto first = [&](std::span<const Neighbour> found) {
        return found.first(std::min(static_cast<std::size_t>(grid[row].k), found.size()));
      };
      const std::pmr::vector<Candidate> ranked =
          averages_costs(grid[row])
              ? average_costs(first(all), by_cost, set.allowed_clips(observation))
              : count_votes(first(allowed), by_label->labels(set.mask[i]), grid[row].vote);
      choices[row][i] = ranked.empty() ? set.idle : ranked.front().clip;
    }
  }
}

/// Sets what a model that ranks by pairwise games chooses for the observations that it was not
/// fitted to.
template <typename Model>
void choose_held_out(const TrainingSet& set, const Model& model, const FoldSplit& split,
                     std::vector<int>& choices) {
  for (const int i : split.held_out) {
    const auto first = candidates(model, set.point(i), set.allowed_clips(i), set.idle,
                                  std::pmr::get_default_resource(), 1);
    choices[static_cast<std::size_t>(i)] = first.front().clip;
  }
}

/// Returns the mean score of the choices for observations of the folds before `fold_count`.
double mean_score(std::span<const int> choices, std::span<const int> fold, std::size_t fold_count,
                  const LossFunction& score) {
  double sum = 0;
  int counted = 0;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (static_cast<std::size_t>(fold[i]) >= fold_count) continue;
    sum += score(static_cast<int>(i), choices[i]);
    ++counted;
  }
  return sum / counted;
}

/// Returns the `count` rows with the lowest scores, the first of equals, in ascending order.
std::vector<std::size_t> best_rows(std::vector<std::size_t> rows, std::span<const double> scores,
                                   std::size_t count) {
  std::stable_sort(rows.begin(), rows.end(), [scores](std::size_t a, std::size_t b) {
    return scores[a] < scores[b] || (std::isnan(scores[b]) && !std::isnan(scores[a]));
  });
  rows.resize(count);
  std::sort(rows.begin(), rows.end());
  return rows;
}

SvmModel fit(const TrainingSet& set, const SvmParameters& parameters) {
  return fit_svm(set, parameters);
}
PairwiseModel fit(const TrainingSet& set, const PairwiseParameters& parameters) {
  return fit_pairwise(set, parameters);
}

/// Successive halving (Jamieson and Talwalkar 2016), over folds instead of epochs.
template <typename Parameters>
TunedParameters<Parameters> choose_by_halving(const TrainingSet& set,
                                              std::span<const Parameters> grid,
                                              std::span<const int> fold,
                                              const LossFunction& score) {
  check(set);
  const std::vector<FoldSplit> splits = make_fold_splits(set, fold);
  Choices choices = no_choices(set, grid.size());
  std::vector<std::size_t> left(grid.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<double> scores(grid.size(), std::numeric_limits<double>::infinity());
  for (std::size_t tried = 0;;) {
    const std::size_t until = left.size() > kFinalists ? tried + 1 : splits.size();
    const std::size_t folds = until - tried;
    parallel_for(left.size() * folds, [&](std::size_t task) {
      const std::size_t row = left[task / folds];
      const FoldSplit& split = splits[tried + task % folds];
      choose_held_out(set, fit(split.training, grid[row]), split, choices[row]);
    });
    tried = until;
    for (const std::size_t row : left) {
      scores[row] = mean_score(choices[row], fold, tried, score);
    }
    if (tried == splits.size()) {
      const std::size_t best = best_rows(left, scores, 1).front();
      return {grid[best], scores[best]};
    }
    left = best_rows(left, scores, std::max(std::min(kFinalists, left.size()), left.size() / 4));
  }
}

}  // namespace

std::vector<int> assign_folds(std::span<const int> label, int fold_count, std::uint64_t seed) {
  if (fold_count < 2 || static_cast<std::size_t>(fold_count) > label.size()) {
    throw Error("", "cross-validation needs at least 2 folds and at most one per observation (" +
                        std::to_string(label.size()) + "), not " + std::to_string(fold_count));
  }
  std::map<int, std::vector<std::size_t>> observations_of;
  for (std::size_t i = 0; i < label.size(); ++i) {
    observations_of[label[i]].push_back(i);
  }
  // The standard defines the engine exactly, but not its distributions and std::shuffle.
  std::mt19937_64 random(seed);
  std::vector<int> fold(label.size());
  int next = 0;
  for (auto& [clip, observations] : observations_of) {
    for (std::size_t i = observations.size(); i > 1; --i) {
      std::swap(observations[i - 1], observations[random() % i]);
    }
    for (const std::size_t observation : observations) {
      fold[observation] = next;
      next = (next + 1) % fold_count;
    }
  }
  return fold;
}

std::vector<int> limit_folds(std::span<const int> fold) {
  const int all = fold.empty() ? 0 : *std::max_element(fold.begin(), fold.end()) + 1;
  int enough = 0;
  for (std::ptrdiff_t held_out = 0; enough < all && held_out < kEnough; ++enough) {
    held_out += std::count(fold.begin(), fold.end(), enough);
  }
  std::vector<int> few(fold.begin(), fold.end());
  std::replace_if(
      few.begin(), few.end(), [enough](int f) { return f >= enough; }, kNeverHeldOut);
  return few;
}

std::size_t argmin(std::span<const double> scores) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < scores.size(); ++i) {
    if (scores[i] < scores[best] || (std::isnan(scores[best]) && !std::isnan(scores[i]))) {
      best = i;
    }
  }
  return best;
}

TunedParameters<SvmParameters> choose_parameters(const TrainingSet& set,
                                                 std::span<const SvmParameters> grid,
                                                 std::span<const int> fold,
                                                 const LossFunction& score) {
  return choose_by_halving(set, grid, fold, score);
}

TunedParameters<KnnParameters> choose_parameters(const TrainingSet& set,
                                                 std::span<const KnnParameters> grid,
                                                 std::span<const int> fold,
                                                 const LossFunction& score) {
  check(set);
  const std::vector<FoldSplit> splits = make_fold_splits(set, fold);
  Choices choices = no_choices(set, grid.size());
  parallel_for(splits.size(),
               [&](std::size_t f) { choose_for_fold(set, grid, splits[f], choices); });
  std::vector<double> scores;
  for (const std::vector<int>& row : choices) {
    scores.push_back(mean_score(row, fold, splits.size(), score));
  }
  const std::size_t best = argmin(scores);
  return {grid[best], scores[best]};
}

TunedParameters<PairwiseParameters> choose_parameters(const TrainingSet& set,
                                                      std::span<const PairwiseParameters> grid,
                                                      std::span<const int> fold,
                                                      const LossFunction& score) {
  return choose_by_halving(set, grid, fold, score);
}

NetworkValidation validate_network(const TrainingSet& set, const NetworkParameters& parameters,
                                   std::span<const int> fold, const LossFunction& score) {
  check(set);
  const std::vector<FoldSplit> splits = make_fold_splits(set, fold);
  std::vector<int> choices(set.label.size());
  double excess = 0;
  double held_out = 0;
  for (const FoldSplit& split : splits) {
    const NetworkModel model = fit_network(split.training, parameters);
    for (const int i : split.held_out) {
      choices[static_cast<std::size_t>(i)] =
          candidates(model, set.point(i), set.allowed_clips(i), set.idle).front().clip;
    }
    const auto count = static_cast<double>(split.held_out.size());
    excess += cost_variance_ns(model, subset(set, split.held_out)) * count;
    held_out += count;
  }
  return {.mean_score = mean_score(choices, fold, splits.size(), score),
          .variance_ns = std::max(excess / held_out, 0.0)};
}

}  // namespace flinch::models
