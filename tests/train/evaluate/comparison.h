// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "tests/train/store/made_up_store.h"
#include "train/fit/feature_derivation.h"
#include "train/report/report.h"

namespace flinch::train {

inline constexpr std::array kTestMethods{Method::knn, Method::svm};

inline Store made_up_store(std::uint64_t count, std::uint64_t seed = 5) {
  Store store;
  store.header = made_up_header();
  store.header.seed = seed;
  store.observations = made_up_observations(store.header, 0, count);
  return store;
}

inline CostModel default_cost(const StoreHeader& header) {
  return make_cost_model(header, vulnerability_profiles()[0], 0.1);
}

/// Inputs of a comparison. Its clock advances by `tick_s` per call.
struct Comparison {
  explicit Comparison(TrainTestSplit made, double tick_s = 1)
      : split(std::move(made)), cost_model(default_cost(split.header)) {
    double time_s = 0;
    const Clock clock = [time_s, tick_s]() mutable { return time_s += tick_s; };
    fitted = fit_methods(split.header, split.fitted, cost_model, kTestMethods, 1, clock);
    evaluation = evaluate(split, cost_model, fitted, 1, clock);
  }
  StudyPlan plan() const { return {split, cost_model, kTestMethods, 1}; }

  TrainTestSplit split;
  CostModel cost_model;
  std::vector<FittedMethod> fitted;
  Evaluation evaluation;
};

inline Report report_of(const Comparison& comparison) {
  Report report;
  report.evaluation = comparison.evaluation;
  report.methods = summaries_of(comparison.fitted);
  report.groups = group_rows(comparison.split, comparison.evaluation, 1);
  report.directions = direction_rows(comparison.split, comparison.evaluation);
  report.confusions = confusion_rows(comparison.split, comparison.evaluation);
  report.reliability = reliability(comparison.evaluation);
  report.noise = noise_rows(comparison.plan(), comparison.fitted);
  return report;
}

}  // namespace flinch::train
