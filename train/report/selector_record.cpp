// SPDX-License-Identifier: MIT
#include "train/report/selector_record.h"

#include <nlohmann/json.hpp>

#include "database/files/provenance.h"
#include "train/report/cost_provenance.h"
#include "train/report/report.h"

namespace flinch::train {
namespace {

std::string selector_provenance(const SelectorChoice& choice, const Store& store) {
  const SelectorChoice usual;
  database::Provenance made{.command = "train", .seed = choice.seed.value_or(store.header.seed)};
  add_option("model", name_of(choice.method), name_of(usual.method), made);
  add_option("features", choice.feature_set, usual.feature_set, made);
  made.inputs.push_back({"store", "", store.hash, store.header.provenance});
  add_cost_options({choice.brawn, choice.vulnerability, choice.pain}, made);
  if (choice.fixed.libsvm_defaults) made.options.emplace_back("parameters", "libsvm");
  add_option("k", choice.fixed.k, made);
  add_option("c", choice.fixed.c, made);
  add_option("gamma", choice.fixed.gamma, made);
  add_option("degree", choice.fixed.degree, made);
  add_option("coef0", choice.fixed.coef0, made);
  if (choice.without_clips) made.options.emplace_back("without-clips", "true");
  return database::provenance_text(made);
}

}  // namespace

SelectorRecord make_selector_record(const SelectorChoice& choice, const Store& store,
                                    const Training& training) {
  return {.provenance = selector_provenance(choice, store),
          .scenarios = store.observations.size(),
          .parameters = parameters_document(training.parameter_values).dump(-1, ' ', true),
          .cross_validated_regret_ns = training.cross_validated_regret_ns,
          .idle_regret_ns = training.idle_regret_ns,
          .distribution = store.header.distribution,
          .simulation = store.header.simulation};
}

}  // namespace flinch::train
