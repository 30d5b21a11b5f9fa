// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "database/files/file_io.h"
#include "program/command.h"
#include "program/comparison_table.h"
#include "program/page.h"
#include "train/fit/feature_derivation.h"
#include "train/report/report.h"

namespace flinch::program {

namespace {

constexpr const char* kPageName = "report.html";

struct CompareOptions {
  std::string store;
  std::string test;
  std::string report;
  std::vector<std::string> models;
  std::string features;
  CostOptions cost;
  bool curves = false;
  bool transfer = false;
  bool ablation = false;
  bool force = false;
  bool json = false;
};

double now_s() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void tell(const std::string& what) {
  std::cerr << "fitting " << what << '\n';
}

train::Store read_with_features(const std::string& path, const std::string& set) {
  train::Store store = train::read_store(path);
  derive_features(train::layout_for(set, store.header), store);
  return store;
}

train::TrainTestSplit read_split(const CompareOptions& options, train::Store store) {
  if (options.test.empty()) return split_of(std::move(store));
  train::Store test = read_with_features(options.test, options.features);
  require_independent(store, test, options.test);
  return split_of(std::move(store), std::move(test));
}

std::vector<train::Method> methods_of(const CompareOptions& options) {
  std::vector<train::Method> chosen;
  for (const train::Method method : train::methods()) {
    const bool wanted =
        options.models.empty() ||
        std::ranges::find(options.models, train::name_of(method)) != options.models.end();
    if (wanted) chosen.push_back(method);
  }
  return chosen;
}

void check_models(const CompareOptions& options) {
  std::set<std::string> seen;
  for (const std::string& model : options.models) {
    if (!seen.insert(model).second) {
      throw UsageError("--models names " + model + " twice; name each model once");
    }
  }
}

void check_report(const CompareOptions& options) {
  if (options.report.empty()) return;
  std::vector<database::Output> files;
  for (const std::string& name : train::report_file_names())
    files.push_back({name, database::FileKind::text, ""});
  files.push_back({kPageName, database::FileKind::text, ""});
  database::check_output_folder(options.report, files,
                                {options.store, options.test, vulnerability_file(options.cost)},
                                overwrite_of(options.force));
}

/// Writes the report's page, or takes an earlier report's away if there is none to fill.
void write_page(const std::string& page, const Json& document, const std::string& folder) {
  const std::filesystem::path file = std::filesystem::path(folder) / kPageName;
  if (page.empty()) {
    std::error_code error;
    std::filesystem::remove(file, error);
  } else {
    database::write_file_atomically(file.string(), page_with_report(page, document.dump()));
  }
}

train::StoreOrigin origin_of(const train::StoreHeader& header) {
  return {header.seed, header.distribution, header.simulation};
}

void run_compare(const CompareOptions& options) {
  check_models(options);
  check_report(options);
  const std::string page = options.report.empty() ? "" : find_page(kReportPage);
  if (!options.report.empty() && page.empty()) {
    std::cerr << "there will be no report.html, only its data: this program was built without the "
                 "packages of the page; scripts/setup fetches them\n";
  }
  const train::VulnerabilityProfile vulnerability = vulnerability_of(options.cost);
  train::Store store = read_with_features(options.store, options.features);
  const std::uint64_t seed = store.header.seed;
  const train::CostModel cost_model =
      make_cost_model(store.header, vulnerability, options.cost.brawn);
  train::Report report;
  report.version = FLINCH_VERSION;
  report.options = {options.features, options.curves, options.transfer, options.ablation};
  report.prevention = train::prevention_rows(store, train::label(store.observations, cost_model));
  const train::TrainTestSplit split = read_split(options, std::move(store));
  const std::vector<train::Method> chosen = methods_of(options);
  const train::StudyPlan plan{split, cost_model, chosen, seed};

  const std::vector<train::FittedMethod> fitted =
      fit_methods(split.header, split.fitted, cost_model, chosen, seed, now_s);
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
  report.evaluation = train::evaluate(split, cost_model, fitted, seed, now_s);
  report.kinds = train::kind_rows(split, report.evaluation, seed);
  report.methods = train::summaries_of(fitted);
  report.groups = train::group_rows(split, report.evaluation, seed);
  report.directions = train::direction_rows(split, report.evaluation);
  report.confusions = train::confusion_rows(split, report.evaluation);
  report.reliability = train::reliability(report.evaluation);
  report.brawn = train::brawn_rows(split, cost_model);
  report.noise = train::noise_rows(plan, fitted);
  if (options.curves) report.curves = train::learning_curve_rows(plan, tell);
  if (options.transfer) report.transfer = train::transfer_rows(plan, tell);
  if (options.ablation) report.ablation = train::ablation_rows(plan, tell);

  Json document = train::report_document(report);
  document["timing"] = train::timing_document(report.evaluation);
  if (!options.report.empty()) {
    train::write_report(report, split, options.report);
    write_page(page, document, options.report);
  }
  if (options.json) {
    print(document);
  } else {
    std::cout << comparison_text(report);
  }
}

}  // namespace

Command compare_command() {
  auto options = std::make_shared<CompareOptions>();
  return {
      .name = "compare",
      .summary = "Fit selectors to a store and compare them on the same scenarios",
      .required = {{"STORE", "store made by flinch simulate", &options->store}},
      .optional = join(
          {{{"--test", "store of test scenarios (default: every fourth of STORE)", &options->test},
            {"--report", "folder for a page with charts and its data, created if missing",
             &options->report},
            {"--models", "models to fit (default: all)", &options->models, OneOf{method_names()}},
            features_option(options->features),
            {"--curves", "also fit to fewer scenarios", &options->curves},
            {"--transfer", "also fit for other brawns", &options->transfer},
            {"--ablation", "also fit with other features", &options->ablation}},
           cost_options(options->cost),
           {force_option(options->force), json_option(options->json)}}),
      .notes =
          "Protection is 0 for standing still and 1 for the exhaustive choice; intervals are\n"
          "bootstrapped over the test scenarios.\n\n"
          "Example:\n  flinch compare real.flinchobs --test test.flinchobs --report report",
      .run = [options] { run_compare(*options); }};
}

}  // namespace flinch::program
