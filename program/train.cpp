// SPDX-License-Identifier: MIT
#include <omp.h>

#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <span>

#include "database/library/library.h"
#include "program/command.h"
#include "program/log.h"
#include "program/printable.h"
#include "program/unanswered.h"
#include "train/fit/feature_derivation.h"
#include "train/fit/labels.h"
#include "train/fit/selector_writer.h"
#include "train/fit/training.h"
#include "train/report/report.h"
#include "train/report/selector_record.h"
#include "train/store/store.h"

namespace flinch::program {

namespace {

/// Where parameters come from that no option gives.
constexpr std::array kParameterSources{"cross-validation", "libsvm"};

struct TrainOptions {
  std::string store;
  std::string selector;
  std::string model{train::name_of(train::kDefaultMethod)};
  std::string features;
  CostOptions cost;
  std::optional<std::uint64_t> seed;
  std::string parameters{kParameterSources[0]};
  std::optional<int> k;
  std::optional<int> degree;
  std::optional<double> c;
  std::optional<double> gamma;
  std::optional<double> coef0;
  std::optional<int> threads;
  bool without_clips = false;
  bool force = false;
  bool json = false;
};

/// Below this number of scenarios, a selector's protection rises steeply with it: docs/selectors.md
/// has figures.
constexpr std::size_t kEnoughScenarios = 200;

std::vector<std::string> warnings_on(const train::Store& store) {
  const std::size_t count = store.observations.size();
  if (count >= kEnoughScenarios) return {};
  return {std::to_string(count) +
          " scenarios are too few to trust the selector; simulate at least " +
          std::to_string(kEnoughScenarios)};
}

train::FixedParameters fixed_parameters(const TrainOptions& options) {
  return {.k = options.k,
          .c = options.c,
          .gamma = options.gamma,
          .degree = options.degree,
          .coef0 = options.coef0,
          .libsvm_defaults = options.parameters == kParameterSources[1]};
}

train::SelectorChoice choice_of(const TrainOptions& options) {
  return {.method = *train::method_named(options.model),
          .feature_set = options.features,
          .brawn = options.cost.brawn,
          .vulnerability = options.cost.vulnerability,
          .pain = options.cost.pain,
          .seed = options.seed,
          .fixed = fixed_parameters(options),
          .without_clips = options.without_clips};
}

Json summary_of(const TrainOptions& options, const train::Store& store,
                const std::string& vulnerability, const train::Training& training) {
  Json summary{{"kind", "selector"},
               {"file", options.selector},
               {"model", options.model},
               {"features", options.features},
               {"library_hash", database::hash_text(store.header.library_hash)},
               {"scenarios", store.observations.size()},
               {"seed", options.seed.value_or(store.header.seed)},
               {"brawn", options.cost.brawn},
               {"vulnerability", vulnerability},
               {"parameters", train::parameters_document(training.parameter_values)},
               {"cross_validated_regret_ns", training.cross_validated_regret_ns},
               {"warnings", warnings_on(store)},
               {"unanswered", unanswered(store.header.clips)}};
  if (const auto* svm = std::get_if<models::SvmModel>(&training.selector.model)) {
    summary["classes"] = svm->class_count();
    summary["support_vectors"] = svm->vector_count();
  }
  return summary;
}

std::vector<Option> fitting_options(TrainOptions& options) {
  const OneOf sources{{kParameterSources.begin(), kParameterSources.end()}};
  return {
      {"--seed", "seed of the folds of cross-validation (default: the store's)", &options.seed},
      {"--parameters", "what chooses the parameters that are not given below", &options.parameters,
       sources},
      {"-k", "number of neighbours of knn, knn_cost", &options.k, Range{1, models::kMaxNeighbours}},
      {"--c", "C of svm, svm_rbf, pairwise_cost", &options.c, Range{1e-6, 1e6}},
      {"--gamma", "gamma of the kernel of svm, svm_rbf", &options.gamma, Range{1e-6, 1e6}},
      {"--degree", "degree of the kernel of svm", &options.degree, Range{1, 10}},
      {"--coef0", "coef0 of the kernel of svm", &options.coef0, Range{-1e3, 1e3}}};
}

void run_train(const TrainOptions& options) {
  database::check_outputs({{options.selector, database::FileKind::selector, ""}},
                          {options.store, vulnerability_file(options.cost)},
                          overwrite_of(options.force));
  const train::VulnerabilityProfile vulnerability = vulnerability_of(options.cost);
  if (options.threads) omp_set_num_threads(*options.threads);
  train::Store store = read_labelled_store(options.store, options.cost);
  derive_features(train::layout_for(options.features, store.header), store);
  const train::CostModel cost_model =
      make_cost_model(store.header, vulnerability, options.cost.brawn);
  const train::Training training = train::train_selector(
      store.header, store.observations, cost_model, *train::method_named(options.model),
      options.seed.value_or(store.header.seed), fixed_parameters(options));
  const train::SelectorRecord record =
      train::make_selector_record(choice_of(options), store, training);
  const std::span<const std::byte> clips =
      options.without_clips ? std::span<const std::byte>() : store.header.library_file;
  train::write_selector(training.selector, clips, &record, options.selector);
  const Json summary = summary_of(options, store, vulnerability.name, training);
  if (options.json) {
    print(summary);
    return;
  }
  std::cout << printable(options.selector) << ": " << options.model << " of "
            << store.observations.size() << " scenarios of " << printable(store.header.library_name)
            << '\n';
  const bool all_chosen = fixed_parameters(options) == train::FixedParameters{};
  std::cout << (all_chosen ? "parameters, chosen by cross-validation: " : "parameters: ")
            << training.parameters
            << "\nmean regret in cross-validation: " << training.cross_validated_regret_ns
            << " N s\n";
  for (const std::string& warning : warnings_on(store)) log_note(warning);
  for (const std::string& line : unanswered(store.header.clips)) log_note(line);
}

}  // namespace

Command train_command() {
  auto options = std::make_shared<TrainOptions>();
  return {.name = "train",
          .summary = "Fit a selector to a store; cross-validation chooses the parameters",
          .required = {{"STORE", "store made by flinch simulate", &options->store},
                       {"--out", "selector file to write", &options->selector}},
          .optional = join({{{"--model", "model to fit", &options->model, OneOf{method_names()}},
                             features_option(options->features)},
                            label_options(options->cost),
                            fitting_options(*options),
                            {{"--without-clips",
                              "leave the clips out of the file, for selectors that share a library",
                              &options->without_clips},
                             threads_option(options->threads),
                             force_option(options->force),
                             json_option(options->json)}}),
          .notes =
              "A selector without clips is used with its library, whose file is beside it.\n\n"
              "Example:\n  flinch train real.flinchobs --out real.flinch",
          .run = [options] { run_train(*options); }};
}

}  // namespace flinch::program
