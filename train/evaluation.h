// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/bootstrap.h"
#include "train/cost.h"
#include "train/prevention.h"
#include "train/store.h"
#include "train/training.h"

namespace flinch::train {

/// Whether a scenario is kept out of fitting: every fourth, by its number.
constexpr bool is_held_out(std::uint64_t number) {
  return number % 4 == 3;
}

/// How one selector did on the held-out scenarios.
struct EvaluationRow {
  std::string name;
  std::vector<int> chosen;      ///< clip, one a held-out scenario
  std::vector<double> cost_ns;  ///< of the chosen clip, one a held-out scenario
  double accuracy = 0;          ///< share of scenarios whose label it chose
  double mean_cost_ns = 0;
  double regret_ns = 0;   ///< mean cost minus the oracle's
  double protection = 0;  ///< 0 stands still, 1 is the oracle; not a number if those are the same
  Interval protection_interval;
};

/// Selectors side by side on the same held-out scenarios.
struct Evaluation {
  CostModel cost_model;
  std::size_t fitted_count = 0;           ///< scenarios that were fitted to
  std::vector<Observation> observations;  ///< held out
  std::vector<int> label;                 ///< clip, one a held-out scenario
  /// idle, random, nearest_annotation, knn, svm, oracle. The oracle chooses the label.
  std::vector<EvaluationRow> rows;
  double svm_minus_knn_ns = 0;  ///< paired difference of the mean costs
  Interval svm_minus_knn_interval;
  std::vector<PreventionRow> prevention;  ///< over all scenarios of the store
};

/// Fits SVM and KNN to the scenarios that are not held out and tries all selectors on those that
/// are. `seed` draws folds, the random row and 2000 bootstrap resamples. Throws Error when either
/// part is too small.
Evaluation evaluate(const Store& store, const CostModel& cost_model, std::uint64_t seed);

}  // namespace flinch::train
