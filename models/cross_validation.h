// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "models/knn_fit.h"
#include "models/pairwise_linear_fit.h"
#include "models/svm_fit.h"
#include "models/training_set.h"

namespace flinch::models {

/// What choosing clip `chosen` for observation number `observation` of the set costs; lower is
/// better. Called by one thread, in order.
using Score = std::function<double(int observation, int chosen)>;

/// Deals observations to folds: the fold of each, in [0, fold_count). Stratified: the folds' shares
/// of each label differ by one at most, and so do their sizes. The same everywhere for the same
/// labels, count and seed. Throws Error unless 2 <= fold_count <= number of observations.
std::vector<int> make_folds(std::span<const int> label, int fold_count, std::uint64_t seed);

/// The clip that each parameter set chooses for each observation when it is fitted to the folds
/// that do not hold that observation, with the observation's own mask: one row of set.size() clips
/// a parameter set. Parallel over parameters and folds by OpenMP; the result does not depend on the
/// number of threads.
std::vector<std::vector<int>> held_out_choices(const TrainingSet& set,
                                               std::span<const SvmParameters> grid,
                                               std::span<const int> fold);
std::vector<std::vector<int>> held_out_choices(const TrainingSet& set,
                                               std::span<const KnnParameters> grid,
                                               std::span<const int> fold);
std::vector<std::vector<int>> held_out_choices(const TrainingSet& set,
                                               std::span<const PairwiseParameters> grid,
                                               std::span<const int> fold);

/// The mean score of each row of choices.
std::vector<double> mean_scores(std::span<const std::vector<int>> choices, const Score& score);

/// Index of the least, the first of equals. Not a number is never least; `scores` is not empty.
std::size_t best_of(std::span<const double> scores);

/// The parameters of the grid with the least mean score, the first of equals. A KNN's are all tried
/// on all folds. An SVM's, which take long to fit, are tried on one fold after another: after each
/// only the best quarter goes on, and three of them to all folds, so that the least is that of
/// those three.
template <typename Parameters>
struct Chosen {
  Parameters parameters;
  double mean_score = 0;
};
Chosen<SvmParameters> choose_parameters(const TrainingSet& set, std::span<const SvmParameters> grid,
                                        std::span<const int> fold, const Score& score);
Chosen<KnnParameters> choose_parameters(const TrainingSet& set, std::span<const KnnParameters> grid,
                                        std::span<const int> fold, const Score& score);
Chosen<PairwiseParameters> choose_parameters(const TrainingSet& set,
                                             std::span<const PairwiseParameters> grid,
                                             std::span<const int> fold, const Score& score);

}  // namespace flinch::models
