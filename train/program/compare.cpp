// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "train/evaluation.h"
#include "train/program/command.h"
#include "train/program/table.h"
#include "train/report.h"
#include "train/store.h"

namespace flinch::train::program {

namespace {

struct Options {
  std::string store;
  std::string report;
  CostOptions cost;
  bool json = false;
};

std::string text(const Interval& interval, int decimals) {
  return fixed(interval.low, decimals) + " to " + fixed(interval.high, decimals);
}

void print_table(const Evaluation& evaluation) {
  using enum Table::Align;
  Table table({{"selector"},
               {"accuracy", right},
               {"mean cost, N s", right},
               {"regret, N s", right},
               {"protection", right},
               {"95 %", right}});
  for (const EvaluationRow& row : evaluation.rows) {
    table.add({row.name, fixed(row.accuracy, 3), fixed(row.mean_cost_ns, 4),
               fixed(row.regret_ns, 4), fixed(row.protection, 3),
               text(row.protection_interval, 3)});
  }
  std::cout << "held out: " << evaluation.observations.size()
            << " scenarios; fitted to: " << evaluation.fitted_count << "; brawn "
            << evaluation.cost_model.brawn << "\n\n"
            << table.text()
            << "\nmean cost of svm minus knn: " << fixed(evaluation.svm_minus_knn_ns, 4)
            << " N s (95 %: " << text(evaluation.svm_minus_knn_interval, 4) << ")\n";
}

void print_prevention(const std::vector<PreventionRow>& rows) {
  using enum Table::Align;
  Table table({{"exhaustive choice"},
               {""},
               {"scenarios", right},
               {"idle, N s", right},
               {"choice, N s", right},
               {"prevented", right}});
  for (const PreventionRow& row : rows) {
    table.add({row.group, row.value, std::to_string(row.scenarios), fixed(row.idle_cost_ns, 3),
               fixed(row.oracle_cost_ns, 3), fixed(row.prevented(), 3)});
  }
  std::cout << "\nWhat the library can prevent of the cost of staying idle, over all scenarios of "
               "the store; by target and\ndirection (degrees) of those with "
            << fixed(double{kTimeToAnswer}, 1) << " s or more to impact:\n\n"
            << table.text();
}

void run(const Options& options) {
  const Store store = read_store(options.store);
  const CostModel cost_model =
      make_cost_model(store.header, vulnerability_of(options.cost), options.cost.brawn);
  const Evaluation evaluation = evaluate(store, cost_model, store.header.seed);
  if (!options.report.empty()) write_report(evaluation, store.header, options.report);
  if (options.json) {
    print(report_document(evaluation, store.header));
  } else {
    print_table(evaluation);
    print_prevention(evaluation.prevention);
  }
}

}  // namespace

void add_compare(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "compare", "Fit selectors to three quarters of a store and try them on the rest");
  command->add_option("STORE", options->store, "store that flinch simulate made")->required();
  command->add_option("--report", options->report,
                      "folder for scenarios.csv and report.json, made if missing");
  add_cost_options(*command, options->cost);
  add_json_option(*command, options->json);
  command->footer(
      "Every fourth scenario is held out. Protection is 0 for standing still and 1 for the\n"
      "exhaustive choice; intervals are bootstrapped over the held-out scenarios.\n\n"
      "Example:\n  flinch compare real.flinchobs --report report");
  command->callback([options] { run(*options); });
}

}  // namespace flinch::train::program
