// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "database/files/file_io.h"
#include "program/command.h"
#include "program/comparison_table.h"
#include "program/log.h"
#include "program/page.h"
#include "train/report/comparison.h"

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

train::ComparisonPlan plan_of(const CompareOptions& options) {
  train::ComparisonPlan plan;
  plan.feature_set = options.features;
  plan.methods = methods_of(options);
  plan.brawn = options.cost.brawn;
  plan.vulnerability = vulnerability_of(options.cost);
  plan.vulnerability_choice = options.cost.vulnerability;
  plan.pain_choice = options.cost.pain;
  plan.curves = options.curves;
  plan.transfer = options.transfer;
  plan.ablation = options.ablation;
  plan.read = [&options](const std::string& path) {
    return read_labelled_store(path, options.cost);
  };
  plan.clock = now_s;
  if (options.curves || options.transfer || options.ablation)  // which take long
    plan.progress = [](const std::string& what) { log(LogLevel::info, "fitting " + what); };
  return plan;
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

void run_compare(const CompareOptions& options) {
  check_models(options);
  check_report(options);
  const std::string page = options.report.empty() ? "" : find_report_page();
  const train::Comparison comparison =
      train::compare_methods(options.store, options.test, plan_of(options));
  const train::Report& report = comparison.report;
  Json document = train::report_document(report);
  document["timing"] = train::timing_document(report.evaluation);
  if (!options.report.empty()) {
    train::write_report(report, comparison.split, options.report);
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
           label_options(options->cost),
           {force_option(options->force), json_option(options->json)}}),
      .notes =
          "Protection is 0 for standing still and 1 for the exhaustive choice; intervals are\n"
          "bootstrapped over the test scenarios.\n\n"
          "Example:\n  flinch compare real.flinchobs --test test.flinchobs --report report",
      .run = [options] { run_compare(*options); }};
}

}  // namespace flinch::program
