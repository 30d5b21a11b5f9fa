// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "models/fit/knn_fit.h"
#include "models/fit/network_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "models/fit/training_set.h"

namespace flinch::models {

/// What choosing clip `chosen` for observation number `observation` of the set costs; lower is
/// better. Called by one thread, in order.
using LossFunction = std::function<double(int observation, int chosen)>;

/// Deals observations to folds: the fold of each, in [0, fold_count). Stratified: the folds' shares
/// of each label differ by one at most, and so do their sizes. The same everywhere for the same
/// labels, count and seed. Throws Error unless 2 <= fold_count <= number of observations.
std::vector<int> assign_folds(std::span<const int> label, int fold_count, std::uint64_t seed);

/// An observation that is never held out, as its fold.
inline constexpr int kNeverHeldOut = -1;

/// The folds from the first that hold 1500 observations together, or all of them where none do; the
/// other observations become kNeverHeldOut. So many tell parameters apart, and a model that takes
/// long to fit is fitted a few times less.
std::vector<int> limit_folds(std::span<const int> fold);

/// Index of the least, the first of equals. Not a number is never least; `scores` is not empty.
std::size_t argmin(std::span<const double> scores);

/// The parameters of the grid with the least mean score, the first of equals; `fold` has each
/// observation's, and the score is of what models that were not fitted to an observation choose
/// for it under its own mask. A KNN's are all tried on all folds. Those of models that take longer
/// to fit are tried on one fold after another: after each only the best quarter goes on, and three
/// of them to all folds, so that the least is that of those three. Parallel by OpenMP; the result
/// does not depend on the number of threads.
template <typename Parameters>
struct TunedParameters {
  Parameters parameters;
  double mean_score = 0;
};
TunedParameters<SvmParameters> choose_parameters(const TrainingSet& set,
                                                 std::span<const SvmParameters> grid,
                                                 std::span<const int> fold,
                                                 const LossFunction& score);
TunedParameters<KnnParameters> choose_parameters(const TrainingSet& set,
                                                 std::span<const KnnParameters> grid,
                                                 std::span<const int> fold,
                                                 const LossFunction& score);
TunedParameters<PairwiseParameters> choose_parameters(const TrainingSet& set,
                                                      std::span<const PairwiseParameters> grid,
                                                      std::span<const int> fold,
                                                      const LossFunction& score);

/// How networks of these parameters do on observations that they were not fitted to: the mean score
/// of what they choose, and the variance that expected costs lack there, as cost_variance_ns()
/// tells it but never below 0.
struct NetworkValidation {
  double mean_score = 0;
  double variance_ns = 0;
};
NetworkValidation validate_network(const TrainingSet& set, const NetworkParameters& parameters,
                                   std::span<const int> fold, const LossFunction& score);

}  // namespace flinch::models
