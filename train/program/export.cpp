// SPDX-License-Identifier: MIT
#include "train/export.h"

#include <iostream>
#include <memory>

#include "database/file_io.h"
#include "motion/error.h"
#include "train/labels.h"
#include "train/program/command.h"
#include "train/store.h"

namespace flinch::train::program {

namespace {

struct Options {
  std::string store;
  std::string file;
  CostOptions cost;
  bool json = false;
};

void run(const Options& options) {
  const bool libsvm = options.file.ends_with(".libsvm");
  if (!libsvm && !options.file.ends_with(".csv"))
    throw Error(options.file, "unknown kind of file; let it end in .libsvm or .csv");
  const Store store = read_store(options.store);
  const CostModel cost_model =
      make_cost_model(store.header, vulnerability_of(options.cost), options.cost.brawn);
  const Labels labels = label(store.observations, cost_model);
  database::write_file_atomically(
      options.file, libsvm ? libsvm_text(store.observations, labels) : csv_text(store, labels));
  if (options.json) {
    print({{"kind", libsvm ? "libsvm" : "csv"},
           {"file", options.file},
           {"scenarios", store.observations.size()}});
  } else {
    std::cout << options.file << ": " << store.observations.size() << " scenarios\n";
  }
}

}  // namespace

void add_export(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("export", "Write a store's data for other tools");
  command->add_option("STORE", options->store, "store that flinch simulate made")->required();
  command
      ->add_option("--out", options->file,
                   "FILE.libsvm (scaled features and labels) or FILE.csv (named columns)")
      ->required();
  add_cost_options(*command, options->cost);
  add_json_option(*command, options->json);
  command->footer("Example:\n  flinch export real.flinchobs --out real.libsvm");
  command->callback([options] { run(*options); });
}

}  // namespace flinch::train::program
