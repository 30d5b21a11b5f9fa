// SPDX-License-Identifier: MIT
#include "train/evaluation.h"

#include <functional>
#include <limits>
#include <span>

#include "features/random.h"
#include "models/baseline.h"
#include "motion/error.h"
#include "train/labels.h"

namespace flinch::train {

namespace {

constexpr std::size_t kResamples = 2000;

using Choice = std::function<int(const Observation&)>;

double mean(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double mean_of(std::span<const double> values, std::span<const std::uint32_t> indices) {
  double sum = 0;
  for (const std::uint32_t index : indices) sum += values[index];
  return sum / static_cast<double>(indices.size());
}

// protection = (cost of staying idle - cost) / (cost of staying idle - cost of the oracle)
double protection(double idle, double selector, double oracle) {
  return idle == oracle ? std::numeric_limits<double>::quiet_NaN()
                        : (idle - selector) / (idle - oracle);
}

EvaluationRow make_row(std::string name, const Evaluation& evaluation, const Labels& labels,
                       const Choice& choice) {
  EvaluationRow row;
  row.name = std::move(name);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < evaluation.observations.size(); ++i) {
    const int chosen = choice(evaluation.observations[i]);
    row.chosen.push_back(chosen);
    row.cost_ns.push_back(cost_of_choice(evaluation.observations, labels, i, chosen));
    hits += chosen == labels.clip[i] ? 1U : 0U;
  }
  row.accuracy = static_cast<double>(hits) / static_cast<double>(row.chosen.size());
  row.mean_cost_ns = mean(row.cost_ns);
  return row;
}

void add_rows(const Store& store, std::span<const Observation> fitted, const Labels& labels,
              std::uint64_t seed, Evaluation& evaluation) {
  const StoreHeader& header = store.header;
  const CostModel& cost_model = evaluation.cost_model;
  const auto add = [&](std::string name, const Choice& choice) {
    evaluation.rows.push_back(make_row(std::move(name), evaluation, labels, choice));
  };
  const auto add_fitted = [&](Method method) {
    const Training training = train_selector(header, fitted, cost_model, method, seed);
    add(std::string(name_of(method)), [&](const Observation& observation) {
      return models::select(training.selector, observation.features, observation.scenario.target);
    });
  };
  add("idle", [&](const Observation&) { return header.idle; });
  add("random", [&](const Observation& observation) {
    features::Random random(seed, features::Purpose::baseline, observation.number);
    return models::random_allowed(header.clips, header.idle, observation.scenario.target,
                                  random.bits());
  });
  add("nearest_annotation", [&](const Observation& observation) {
    return models::nearest_annotation(header.clips, header.idle, observation.scenario.target,
                                      azimuth_of(observation.features));
  });
  add_fitted(Method::knn);
  add_fitted(Method::svm);
  std::size_t next = 0;
  add("oracle", [&](const Observation&) { return labels.clip[next++]; });
}

const EvaluationRow& row_named(const Evaluation& evaluation, std::string_view name) {
  for (const EvaluationRow& row : evaluation.rows)
    if (row.name == name) return row;
  throw Error("", "the comparison has no row " + std::string(name));
}

void add_regret_and_intervals(Evaluation& evaluation, std::uint64_t seed) {
  const auto resamples = draw_resamples(evaluation.observations.size(), kResamples, seed);
  const EvaluationRow& idle = row_named(evaluation, "idle");
  const EvaluationRow& oracle = row_named(evaluation, "oracle");
  for (EvaluationRow& row : evaluation.rows) {
    row.regret_ns = row.mean_cost_ns - oracle.mean_cost_ns;
    row.protection = protection(idle.mean_cost_ns, row.mean_cost_ns, oracle.mean_cost_ns);
    row.protection_interval = percentile_interval(resamples, [&](auto indices) {
      return protection(mean_of(idle.cost_ns, indices), mean_of(row.cost_ns, indices),
                        mean_of(oracle.cost_ns, indices));
    });
  }
  const EvaluationRow& svm = row_named(evaluation, "svm");
  const EvaluationRow& knn = row_named(evaluation, "knn");
  evaluation.svm_minus_knn_ns = svm.mean_cost_ns - knn.mean_cost_ns;
  evaluation.svm_minus_knn_interval = percentile_interval(resamples, [&](auto indices) {
    return mean_of(svm.cost_ns, indices) - mean_of(knn.cost_ns, indices);
  });
}

}  // namespace

Evaluation evaluate(const Store& store, const CostModel& cost_model, std::uint64_t seed) {
  Evaluation evaluation;
  evaluation.cost_model = cost_model;
  std::vector<Observation> fitted;
  for (const Observation& observation : store.observations)
    (is_held_out(observation.number) ? evaluation.observations : fitted).push_back(observation);
  if (evaluation.observations.size() < 2)
    throw Error("", "comparing needs at least 8 scenarios and there are " +
                        std::to_string(store.observations.size()) + "; simulate more");
  evaluation.fitted_count = fitted.size();
  const Labels labels = label(evaluation.observations, cost_model);
  evaluation.label = labels.clip;
  add_rows(store, fitted, labels, seed, evaluation);
  add_regret_and_intervals(evaluation, seed);
  evaluation.prevention = prevention_rows(store, label(store.observations, cost_model));
  return evaluation;
}

}  // namespace flinch::train
