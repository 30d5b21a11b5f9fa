// SPDX-License-Identifier: MIT
#include "train/report/export.h"

#include <iostream>
#include <memory>

#include "database/files/file_io.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/printable.h"
#include "train/fit/feature_derivation.h"
#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::program {

namespace {

struct ExportOptions {
  std::string store;
  std::string file;
  std::string scaling;
  std::string features;
  CostOptions cost;
  bool force = false;
  bool json = false;
};

/// Returns the scaling of the store itself, or of the training store that is given.
features::Scaling scaling_for(const ExportOptions& options, const train::Store& store) {
  if (options.scaling.empty()) return scaling_of(store.header, store.observations);
  train::Store fitted = train::read_store(options.scaling);
  derive_features(store.header.layout, fitted);
  return scaling_of(fitted.header, fitted.observations);
}

void run_export(const ExportOptions& options) {
  const bool libsvm = options.file.ends_with(".libsvm");
  if (!libsvm && !options.file.ends_with(".csv"))
    throw Error(options.file, "unknown kind of file; use a name that ends in .libsvm or .csv");
  database::check_outputs(
      {{options.file, database::FileKind::text, libsvm ? " 1:" : "number,target,"}},
      {options.store, options.scaling, vulnerability_file(options.cost)},
      overwrite_of(options.force));
  const features::Layout& layout = features::feature_set_named(options.features)->layout;
  const train::VulnerabilityProfile vulnerability = vulnerability_of(options.cost);
  train::Store store = train::read_store(options.store);
  derive_features(layout, store);
  const train::CostModel cost_model =
      make_cost_model(store.header, vulnerability, options.cost.brawn);
  const train::Labels labels = train::label(store.observations, cost_model);
  database::write_file_atomically(
      options.file, libsvm ? train::libsvm_text(store, labels, scaling_for(options, store))
                           : train::csv_text(store, labels));
  if (options.json) {
    print({{"kind", libsvm ? "libsvm" : "csv"},
           {"file", options.file},
           {"scenarios", store.observations.size()}});
  } else {
    std::cout << printable(options.file) << ": " << store.observations.size() << " scenarios\n";
  }
}

}  // namespace

Command export_command() {
  auto options = std::make_shared<ExportOptions>();
  return {
      .name = "export",
      .summary = "Write a store's data for other tools",
      .required = {{"STORE", "store made by flinch simulate", &options->store},
                   {"--out", "FILE.libsvm (scaled features and labels) or FILE.csv (named columns)",
                    &options->file}},
      .optional = join({{{"--scaled-as",
                          "training store that defines the scaling, for test data "
                          "(default: STORE)",
                          &options->scaling},
                         features_option(options->features)},
                        cost_options(options->cost),
                        {force_option(options->force), json_option(options->json)}}),
      .notes = "Example:\n  flinch export real.flinchobs --out real.libsvm",
      .run = [options] { run_export(*options); }};
}

}  // namespace flinch::program
