// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// What was chosen for a method.
struct MethodSummary {
  std::string name;
  std::string parameters;
  double cross_validated_regret_ns = 0;
};
std::vector<MethodSummary> summaries_of(std::span<const FittedMethod> methods);

/// What a study needs of a split: the same in all of them.
struct StudyPlan {
  const TrainTestSplit& split;
  const CostModel& cost_model;
  std::span<const Method> methods;
  std::uint64_t seed = 1;
};

/// Whom to tell what is being fitted: fits take long.
using ProgressCallback = std::function<void(const std::string& what)>;

/// A method with noise on the features that it is asked with.
struct NoiseRow {
  std::string name;
  double noise = 0;  ///< standard deviation, a share of each feature's half range in fitting
  double regret_ns = 0;
  double protection = 0;
};
/// Normal noise on every feature but the target's, the same draws for every method and, scaled, for
/// every level; the mask is that of the true target.
std::vector<NoiseRow> noise_rows(const StudyPlan& plan, std::span<const FittedMethod> methods);

/// A method fitted to the first so many scenarios.
struct LearningCurveRow {
  std::string name;
  std::size_t fitted_count = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// At 500, 1000, 2000, 5000, 10,000, 20,000 and 50,000 scenarios as far as there are so many, and
/// at all. Parameters are chosen anew at each size.
std::vector<LearningCurveRow> learning_curve_rows(const StudyPlan& plan,
                                                  const ProgressCallback& progress);

/// A method fitted for one brawn and judged for another.
struct TransferRow {
  std::string name;
  double fitted_brawn = 0;
  double judged_brawn = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// Each of 0, 0.1, 0.3 and 0.5 against each.
std::vector<TransferRow> transfer_rows(const StudyPlan& plan, const ProgressCallback& progress);

/// A method with other features.
struct AblationRow {
  std::string name;
  std::string features;  ///< a set's name, or "geometry without contact"
  int feature_count = 0;
  double cross_validated_regret_ns = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// Every feature set, and every set without each of its groups.
std::vector<AblationRow> ablation_rows(const StudyPlan& plan, const ProgressCallback& progress);

}  // namespace flinch::train
