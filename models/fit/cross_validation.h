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

/// Returns the loss of choosing clip `chosen` for observation `observation` of the set; lower is
/// better. Called by one thread, in order.
using LossFunction = std::function<double(int observation, int chosen)>;

/// Assigns observations to folds: returns the fold of each, in [0, fold_count). Stratified: folds
/// differ by at most one in their number of observations of each label, and in their size. The
/// result depends only on labels, count and seed. Throws Error unless 2 <= fold_count <= number of
/// observations.
std::vector<int> assign_folds(std::span<const int> label, int fold_count, std::uint64_t seed);

/// Fold of an observation that is never held out.
inline constexpr int kNeverHeldOut = -1;

/// Keeps the first folds that together hold 1500 observations, or all where there are fewer; the
/// other observations become kNeverHeldOut. That many are enough to compare parameters, and slow
/// models are fitted fewer times.
std::vector<int> limit_folds(std::span<const int> fold);

/// Returns the index of the minimum, the first of equals. NaN is never the minimum; `scores` is not
/// empty.
std::size_t argmin(std::span<const double> scores);

/// Returns the parameters of the grid with the lowest mean score, the first of equals. `fold` holds
/// each observation's fold. The score is that of the choices, under the observation's own mask, of
/// models that were not fitted to the observation. KNN parameters are all tried on all folds. For
/// models that take longer to fit, folds are tried one after another: after each, only the best
/// quarter continues, and the last three candidates are scored on all folds. Parallel by OpenMP;
/// the result does not depend on the number of threads.
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

/// How networks with these parameters perform on observations that they were not fitted to: the
/// mean score of their choices, and the variance missing from their expected costs, as
/// cost_variance_ns() measures it but at least 0.
struct NetworkValidation {
  double mean_score = 0;
  double variance_ns = 0;
};
NetworkValidation validate_network(const TrainingSet& set, const NetworkParameters& parameters,
                                   std::span<const int> fold, const LossFunction& score);

}  // namespace flinch::models
