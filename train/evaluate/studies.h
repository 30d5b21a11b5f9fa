// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// Results of one method's choices.
struct MethodSummary {
  std::string name;
  std::vector<NamedValue> parameter_values;
  std::string parameters;  ///< the same as text
  double cross_validated_regret_ns = 0;
};
std::vector<MethodSummary> summaries_of(std::span<const FittedMethod> methods);

/// Common inputs of all studies of a split.
struct StudyPlan {
  const TrainTestSplit& split;
  const CostModel& cost_model;
  std::span<const Method> methods;
  std::uint64_t seed = 1;
};

/// Results of a method when its input features are noisy.
struct NoiseRow {
  std::string name;
  double noise = 0;  ///< standard deviation, as a share of each feature's half range in the fit
  double regret_ns = 0;
  double protection = 0;
};
/// Adds normal noise to every feature except the target's. All methods use the same draws and all
/// levels the same draws, scaled; the mask is that of the true target.
std::vector<NoiseRow> noise_rows(const StudyPlan& plan, std::span<const FittedMethod> methods);

/// Results of a method fitted to the first `scenarios` scenarios.
struct LearningCurveRow {
  std::string name;
  std::size_t fitted_count = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// Fits at 500, 1000, 2000, 5000, 10,000, 20,000 and 50,000 scenarios, as far as there are as many,
/// and at all scenarios. Parameters are chosen anew at each size.
std::vector<LearningCurveRow> learning_curve_rows(const StudyPlan& plan,
                                                  const ProgressCallback& progress);

/// Results of a method fitted for one brawn and evaluated for another.
struct TransferRow {
  std::string name;
  double fitted_brawn = 0;
  double judged_brawn = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// Fits for each brawn of 0, 0.1, 0.3 and 0.5 and evaluates for each of them.
std::vector<TransferRow> transfer_rows(const StudyPlan& plan, const ProgressCallback& progress);

/// Results of a method with another set of features.
struct AblationRow {
  std::string name;
  std::string features;  ///< a set's name, or "geometry without contact"
  int feature_count = 0;
  double cross_validated_regret_ns = 0;
  double regret_ns = 0;
  double protection = 0;
};
/// Evaluates every feature set, and every set without each of its groups.
std::vector<AblationRow> ablation_rows(const StudyPlan& plan, const ProgressCallback& progress);

}  // namespace flinch::train
