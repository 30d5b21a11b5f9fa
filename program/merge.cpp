// SPDX-License-Identifier: MIT
#include "train/store/merge.h"

#include <iostream>
#include <memory>

#include "database/files/library_writer.h"
#include "program/command.h"
#include "program/printable.h"
#include "train/store/store.h"

namespace flinch::program {

namespace {

struct MergeOptions {
  std::vector<std::string> stores;
  std::string out;
  bool force = false;
  bool json = false;
};

void run_merge(const MergeOptions& options) {
  const database::Overwrite overwrite = overwrite_of(options.force);
  database::check_outputs({train::store_output(options.out)}, options.stores, overwrite);
  train::merge_stores(options.stores, options.out, overwrite);
  const train::StoreSummary store = train::summarise_store(options.out);
  if (options.json) {
    print({{"kind", "store"},
           {"file", options.out},
           {"first", store.range.first},
           {"scenarios", store.observation_count},
           {"seed", store.header.seed},
           {"library_hash", database::hash_text(store.header.library_hash)}});
    return;
  }
  std::cout << printable(options.out) << ": " << train::text_of(store.range) << " of "
            << printable(store.header.library_name) << ", seed " << store.header.seed << '\n';
}

}  // namespace

Command merge_command() {
  auto options = std::make_shared<MergeOptions>();
  return {
      .name = "merge",
      .summary = "Join stores that each hold a range of the scenarios of one run",
      .required = {{"STORE", "stores made by flinch simulate", &options->stores},
                   {"--out", "store file to write", &options->out}},
      .optional = {force_option(options->force), json_option(options->json)},
      .notes =
          "The stores must be of the same library, seed, distribution and simulation, and leave "
          "no\n"
          "gap between their scenarios. A scenario in several stores must be the same in all. The\n"
          "result is byte for byte the store that a single simulation would have made.\n\n"
          "Example:\n  flinch merge part-*.flinchobs --out all.flinchobs",
      .run = [options] { run_merge(*options); }};
}

}  // namespace flinch::program
