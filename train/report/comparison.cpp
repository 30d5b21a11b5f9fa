// SPDX-License-Identifier: MIT
#include "train/report/comparison.h"

#include <utility>

#include "train/fit/feature_derivation.h"

namespace flinch::train {
namespace {

Store read_with_features(const std::string& path, const ComparisonPlan& plan) {
  Store store = plan.read(path);
  derive_features(layout_for(plan.feature_set, store.header), store);
  return store;
}

TrainTestSplit read_split(Store store, const std::string& test_path, const ComparisonPlan& plan) {
  if (test_path.empty()) return split_of(std::move(store));
  Store test = read_with_features(test_path, plan);
  require_independent(store, test, test_path);
  return split_of(std::move(store), std::move(test));
}

StoreOrigin origin_of(const StoreHeader& header) {
  return {header.seed, header.distribution, header.simulation};
}

/// What the stores tell, before anything is fitted.
Report begin_report(const TrainTestSplit& split, std::uint64_t seed, const ComparisonPlan& plan) {
  Report report;
  report.version = plan.version;
  report.options = {plan.feature_set, plan.curves, plan.transfer, plan.ablation};
  report.fitted_store = origin_of(split.header);
  report.tested_store = origin_of(split.test_header);
  report.library = split.header.library_name;
  report.library_hash = split.header.library_hash;
  report.seed = seed;
  report.fitted_count = split.fitted.size();
  report.tested_count = split.tested.size();
  report.has_test_store = split.has_test_store;
  report.features = split.header.layout.names();
  for (const models::ClipSummary& clip : split.header.clips) report.clips.push_back(clip.name);
  return report;
}

void add_rows(const ComparisonPlan& plan, const StudyPlan& study,
              std::span<const FittedMethod> fitted, Report& report) {
  const TrainTestSplit& split = study.split;
  report.evaluation = evaluate(split, study.cost_model, fitted, study.seed, plan.clock);
  report.kinds = kind_rows(split, report.evaluation, study.seed);
  report.methods = summaries_of(fitted);
  report.groups = group_rows(split, report.evaluation, study.seed);
  report.directions = direction_rows(split, report.evaluation);
  report.confusions = confusion_rows(split, report.evaluation);
  report.reliability = reliability(report.evaluation);
  report.brawn = brawn_rows(split, study.cost_model);
  report.noise = noise_rows(study, fitted);
  if (plan.curves) report.curves = learning_curve_rows(study, plan.progress);
  if (plan.transfer) report.transfer = transfer_rows(study, plan.progress);
  if (plan.ablation) report.ablation = ablation_rows(study, plan.progress);
}

}  // namespace

Comparison compare_methods(const std::string& store_path, const std::string& test_path,
                           const ComparisonPlan& plan) {
  Store store = read_with_features(store_path, plan);
  const std::uint64_t seed = store.header.seed;
  const CostModel cost_model = make_cost_model(store.header, plan.vulnerability, plan.brawn);
  std::vector<PreventionRow> prevention =
      prevention_rows(store, label(store.observations, cost_model));
  Comparison comparison;
  comparison.split = read_split(std::move(store), test_path, plan);
  const TrainTestSplit& split = comparison.split;
  comparison.report = begin_report(split, seed, plan);
  comparison.report.prevention = std::move(prevention);
  const std::vector<FittedMethod> fitted = fit_methods(
      split.header, split.fitted, cost_model, plan.methods, seed, plan.clock, plan.progress);
  add_rows(plan, {split, cost_model, plan.methods, seed}, fitted, comparison.report);
  return comparison;
}

}  // namespace flinch::train
