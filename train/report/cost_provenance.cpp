// SPDX-License-Identifier: MIT
#include "train/report/cost_provenance.h"

#include "database/files/file_kind.h"
#include "train/objective/cost.h"
#include "train/objective/vulnerability.h"

namespace flinch::train {
namespace {

void add_name_or_file(const std::string& option, const std::string& value,
                      database::Provenance& provenance) {
  if (database::names_toml_file(value)) {
    add_inputs(option, {value}, provenance);
  } else {
    provenance.options.emplace_back(option, value);
  }
}

}  // namespace

void add_cost_options(const CostChoice& choice, database::Provenance& provenance) {
  add_option("brawn", choice.brawn, CostModel{}.brawn, provenance);
  if (choice.vulnerability != vulnerability_profiles()[0].name)
    add_name_or_file("vulnerability", choice.vulnerability, provenance);
  if (choice.pain) add_name_or_file("pain", *choice.pain, provenance);
}

}  // namespace flinch::train
