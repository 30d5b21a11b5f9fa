// SPDX-License-Identifier: MIT
#include "train/report/comparison.h"

#include <utility>

#include "database/files/provenance.h"
#include "train/fit/feature_derivation.h"
#include "train/report/cost_provenance.h"

namespace flinch::train {
namespace {

Store read_with_features(const std::string& path, const ComparisonPlan& plan) {
  Store store = plan.read(path);
  derive_features(layout_for(plan.feature_set, store.header), store);
  return store;
}

StoreOrigin origin_of(const StoreHeader& header) {
  return {header.seed, header.distribution, header.simulation};
}

/// The methods as --models has them; empty where all are fitted.
std::string text_of(std::span<const Method> chosen) {
  std::string text;
  if (chosen.size() == methods().size()) return text;
  for (const Method method : chosen) {
    if (!text.empty()) text += ',';
    text += name_of(method);
  }
  return text;
}

std::string comparison_provenance(const ComparisonPlan& plan, const Store& store,
                                  const Store* test) {
  database::Provenance made{.command = "compare", .seed = store.header.seed};
  add_option("models", text_of(plan.methods), std::string(), made);
  add_option("features", plan.feature_set, ComparisonPlan{}.feature_set, made);
  add_option("curves", plan.curves, false, made);
  add_option("transfer", plan.transfer, false, made);
  add_option("ablation", plan.ablation, false, made);
  made.inputs.push_back({"store", "", store.hash, store.header.provenance});
  if (test != nullptr) made.inputs.push_back({"test", "", test->hash, test->header.provenance});
  add_cost_options({plan.brawn, plan.vulnerability_choice, plan.pain_choice}, made);
  return database::provenance_text(made);
}

/// What the stores tell, before anything is fitted.
Report begin_report(const TrainTestSplit& split, std::uint64_t seed, const ComparisonPlan& plan) {
  Report report;
  report.version = std::string(database::flinch_version());
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

/// Splits the scenarios, and tells how the report is made.
TrainTestSplit read_split(Store store, const std::string& test_path, const ComparisonPlan& plan,
                          std::string& provenance) {
  if (test_path.empty()) {
    provenance = comparison_provenance(plan, store, nullptr);
    return split_of(std::move(store));
  }
  Store test = read_with_features(test_path, plan);
  require_independent(store, test, test_path);
  provenance = comparison_provenance(plan, store, &test);
  return split_of(std::move(store), std::move(test));
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
  std::string provenance;
  comparison.split = read_split(std::move(store), test_path, plan, provenance);
  const TrainTestSplit& split = comparison.split;
  comparison.report = begin_report(split, seed, plan);
  comparison.report.provenance = std::move(provenance);
  comparison.report.prevention = std::move(prevention);
  const std::vector<FittedMethod> fitted = fit_methods(
      split.header, split.fitted, cost_model, plan.methods, seed, plan.clock, plan.progress);
  add_rows(plan, {split, cost_model, plan.methods, seed}, fitted, comparison.report);
  return comparison;
}

}  // namespace flinch::train
