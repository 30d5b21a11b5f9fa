// SPDX-License-Identifier: MIT
// Compares one selector for all kinds of threats with one selector per kind, and with one that is
// not told size, mass and kind, and prints the tables of docs/threats.md:
//
//     kind_study FITTED_STORE TEST_STORE
//
// All are networks. The selector of a kind is fitted to that kind's scenarios of the store alone.
#include <cstdio>
#include <string>
#include <vector>

#include "tests/bench/study.h"
#include "train/evaluate/bootstrap.h"
#include "train/evaluate/evaluation.h"
#include "train/fit/feature_derivation.h"

namespace flinch {
namespace {

using train::Estimate;
using train::Observation;

std::vector<Observation> of_kind(const std::vector<Observation>& observations, int kind) {
  std::vector<Observation> members;
  for (const Observation& observation : observations)
    if (observation.scenario.threat.kind == kind) members.push_back(observation);
  return members;
}

/// What a selector costs in each of these scenarios, N·s, beside idling and the oracle.
struct Costs {
  std::vector<double> idle, oracle, selector;
};

Costs costs_of(const train::StoreHeader& header, const std::vector<Observation>& tested,
               const train::CostModel& model, const models::Selector& selector) {
  const train::Labels labels = label(tested, model);
  Costs costs;
  for (std::size_t i = 0; i < tested.size(); ++i) {
    const int clip = select(selector, tested[i].features, tested[i].scenario.target);
    costs.idle.push_back(cost_of_choice(tested, labels, i, header.idle));
    costs.oracle.push_back(cost_of_choice(tested, labels, i, labels.clip[i]));
    costs.selector.push_back(cost_of_choice(tested, labels, i, clip));
  }
  return costs;
}

Estimate protection(const Costs& costs, std::uint64_t seed) {
  const auto resamples = train::draw_resamples(costs.idle.size(), train::kResampleCount, seed);
  using train::resampled_mean;
  return train::estimate(train::protection_of, resampled_mean(costs.idle, resamples),
                         resampled_mean(costs.selector, resamples),
                         resampled_mean(costs.oracle, resamples));
}

std::string text(const Estimate& estimate) {
  char line[64];
  std::snprintf(line, sizeof line, "%.3f (%.3f to %.3f)", estimate.value, estimate.interval.low,
                estimate.interval.high);
  return line;
}

models::Selector fitted(const train::Store& store, const std::vector<Observation>& observations,
                        const train::CostModel& model) {
  return train_selector(store.header, observations, model, train::Method::network,
                        store.header.seed)
      .selector;
}

void print_kinds(const train::Store& store, const train::Store& test, const train::CostModel& model,
                 const models::Selector& for_all) {
  const std::uint64_t seed = store.header.seed;
  std::printf(
      "| kind | fitted | tested | one selector for all | one selector per kind |\n"
      "| --- | ---: | ---: | --- | --- |\n");
  for (std::size_t kind = 0; kind < store.header.kinds.size(); ++kind) {
    const auto training = of_kind(store.observations, static_cast<int>(kind));
    const auto tested = of_kind(test.observations, static_cast<int>(kind));
    const Costs together = costs_of(store.header, tested, model, for_all);
    const Costs alone = costs_of(store.header, tested, model, fitted(store, training, model));
    std::printf("| %s | %zu | %zu | %s | %s |\n", store.header.kinds[kind].name.c_str(),
                training.size(), tested.size(), text(protection(together, seed)).c_str(),
                text(protection(alone, seed)).c_str());
  }
}

/// Compares with a selector that is not told size, mass and kind.
void print_untold(train::Store& store, train::Store& test, const train::CostModel& model,
                  const models::Selector& for_all) {
  const Costs told = costs_of(store.header, test.observations, model, for_all);
  const features::Layout plain = features::feature_sets().front().layout;
  derive_features(plain, store);
  derive_features(plain, test);
  const Costs untold =
      costs_of(store.header, test.observations, model, fitted(store, store.observations, model));
  const auto resamples =
      train::draw_resamples(told.idle.size(), train::kResampleCount, store.header.seed);
  const auto difference =
      train::estimate(std::minus{}, train::resampled_mean(told.selector, resamples),
                      train::resampled_mean(untold.selector, resamples));
  std::printf("\nall kinds: protection %s, without size, mass and kind %s\n",
              text(protection(told, store.header.seed)).c_str(),
              text(protection(untold, store.header.seed)).c_str());
  std::printf("mean cost with them less without, N s: %s\n", text(difference).c_str());
}

void run(const bench::StudyArguments& arguments) {
  train::Store store = train::read_store(arguments.text(0));
  train::Store test = train::read_store(arguments.text(1));
  const std::string_view features = features::feature_sets().front().name;
  derive_features(train::layout_for(features, store.header), store);
  derive_features(train::layout_for(features, test.header), test);
  require_independent(store, test, arguments.text(1));
  const train::CostModel model =
      make_cost_model(store.header, train::vulnerability_profiles()[0], train::CostModel{}.brawn);
  const models::Selector for_all = fitted(store, store.observations, model);
  print_kinds(store, test, model, for_all);
  print_untold(store, test, model, for_all);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"kind_study FITTED_STORE TEST_STORE", 2, 2},
                                   flinch::run);
}
