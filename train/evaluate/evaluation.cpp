// SPDX-License-Identifier: MIT
#include "train/evaluate/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/random.h"
#include "models/baseline.h"
#include "runtime/selection.h"
#include "train/fit/selector_writer.h"

namespace flinch::train {

namespace {

constexpr std::array<std::string_view, 2> kPairedReferences{"svm", "knn"};

Ranking single_choice(int clip) {
  Ranking ranking;
  ranking.best[0].clip = clip;
  ranking.count = 1;
  return ranking;
}

bool contains(const Ranking& ranking, int clip) {
  const auto first = ranking.best.begin();
  const auto end = first + static_cast<std::ptrdiff_t>(ranking.count);
  return std::any_of(first, end, [clip](const auto& candidate) { return candidate.clip == clip; });
}

EvaluationRow row_of(std::string name, const TrainTestSplit& split, const Evaluation& evaluation,
                     const Chooser& choose) {
  EvaluationRow row;
  row.name = std::move(name);
  for (std::size_t i = 0; i < split.tested.size(); ++i) {
    const Observation& observation = split.tested[i];
    const Ranking ranking = choose(observation);
    const models::Candidate& chosen = ranking.best[0];
    const int label = evaluation.labels.clip[i];
    const std::size_t trial = trial_of(observation, chosen.clip);
    row.chosen.push_back(chosen.clip);
    row.cost_ns.push_back(evaluation.labels.cost[i][trial]);
    row.damage_ns.push_back(
        damage_ns(observation.trials[trial].impulse, evaluation.cost_model.vulnerability));
    row.hit.push_back(chosen.clip == label ? 1 : 0);
    row.hit_in_three.push_back(contains(ranking, label) ? 1 : 0);
    row.vote.push_back(chosen.vote);
    row.expected_cost_ns.push_back(chosen.expected_cost_ns);
  }
  return row;
}

void add_baselines(const TrainTestSplit& split, std::uint64_t seed, Evaluation& evaluation) {
  const StoreHeader& header = split.header;
  const auto add = [&](const char* name, const std::function<int(const Observation&)>& choose) {
    evaluation.rows.push_back(row_of(name, split, evaluation, [&](const Observation& observation) {
      return single_choice(choose(observation));
    }));
  };
  add("idle", [&](const Observation&) { return header.idle; });
  add("random", [&](const Observation& observation) {
    features::Random random(seed, features::RandomStream::baseline, observation.number);
    return models::random_allowed(header.clips, header.idle, observation.scenario.target,
                                  random.bits());
  });
  add("nearest_annotation", [&](const Observation& observation) {
    return models::nearest_annotation(header.clips, header.idle, observation.scenario.target,
                                      azimuth_of(observation.scenario));
  });
}

void add_methods(const TrainTestSplit& split, std::span<const FittedMethod> methods,
                 Evaluation& evaluation) {
  for (const FittedMethod& fitted : methods) {
    const auto choose = [&](const Observation& observation) {
      return ranking_of(fitted.training.selector, observation.features,
                        observation.scenario.target);
    };
    evaluation.rows.push_back(
        row_of(std::string(name_of(fitted.method)), split, evaluation, choose));
  }
}

void add_oracle(const TrainTestSplit& split, Evaluation& evaluation) {
  std::size_t next = 0;
  const auto choose = [&](const Observation&) {
    return single_choice(evaluation.labels.clip[next++]);
  };
  evaluation.rows.push_back(row_of("oracle", split, evaluation, choose));
}

struct RowMeans {
  ResampledMean cost, damage, hit, hit_in_three;
};

void add_estimates(std::uint64_t seed, Evaluation& evaluation) {
  const Resamples resamples = draw_resamples(evaluation.labels.clip.size(), kResampleCount, seed);
  std::vector<RowMeans> means;
  for (const EvaluationRow& row : evaluation.rows) {
    const auto of = [&](const std::vector<double>& values) {
      return resampled_mean(values, resamples);
    };
    means.push_back({of(row.cost_ns), of(row.damage_ns), of(row.hit), of(row.hit_in_three)});
  }
  const auto itself = [](double mean) { return mean; };
  const ResampledMean& idle = means.front().cost;
  const ResampledMean& oracle = means.back().cost;
  for (std::size_t i = 0; i < evaluation.rows.size(); ++i) {
    EvaluationRow& row = evaluation.rows[i];
    const ResampledMean& cost = means[i].cost;
    row.accuracy = estimate(itself, means[i].hit);
    row.top_three = estimate(itself, means[i].hit_in_three);
    row.mean_cost_ns = estimate(itself, cost);
    row.mean_damage_ns = estimate(itself, means[i].damage);
    row.regret_ns = estimate(std::minus{}, cost, oracle);
    row.protection = estimate(protection_of, idle, cost, oracle);
    for (const std::string_view reference : kPairedReferences) {
      const EvaluationRow* from = row_named(evaluation, reference);
      if (from == nullptr || from == &row) continue;
      const auto place = static_cast<std::size_t>(from - evaluation.rows.data());
      row.differences.push_back(
          {std::string(reference), estimate(std::minus{}, cost, means[place].cost)});
    }
  }
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

RowTiming timing_of(const FittedMethod& fitted, std::span<const Observation> observations,
                    const Clock& clock) {
  const models::Selector& selector = fitted.training.selector;
  runtime::Workspace workspace;
  workspace.reserve_memory(runtime::selection_bytes(selector));
  std::array<models::Candidate, 3> best;
  std::vector<double> took_s;
  for (const Observation& observation : observations) {
    const double before_s = clock();
    select(workspace, selector, observation.features, observation.scenario.target, best);
    took_s.push_back(clock() - before_s);
  }
  std::ranges::sort(took_s);
  return {std::string(name_of(fitted.method)), 1e6 * quantile(took_s, 0.5),
          1e6 * quantile(took_s, 0.99), fitted.fit_s, fitted.file_bytes};
}

}  // namespace

std::vector<FittedMethod> fit_methods(const StoreHeader& header,
                                      std::span<const Observation> observations,
                                      const CostModel& cost_model, std::span<const Method> methods,
                                      std::uint64_t seed, const Clock& clock) {
  std::vector<FittedMethod> fitted;
  for (const Method method : methods) {
    const double before_s = clock();
    Training training = train_selector(header, observations, cost_model, method, seed);
    const double fit_s = clock() - before_s;
    const std::size_t bytes = selector_bytes(training.selector).size();
    fitted.push_back({method, std::move(training), fit_s, bytes});
  }
  return fitted;
}

Ranking ranking_of(const models::Selector& selector, const features::FeatureVector& features,
                   motion::Target threatened) {
  const auto candidates = models::candidates(selector, features, threatened);
  Ranking ranking;
  ranking.count = std::min(candidates.size(), ranking.best.size());
  std::copy_n(candidates.begin(), ranking.count, ranking.best.begin());
  return ranking;
}

double protection_of(double idle, double cost, double oracle) {
  return idle == oracle ? std::numeric_limits<double>::quiet_NaN()
                        : (idle - cost) / (idle - oracle);
}

const EvaluationRow* row_named(const Evaluation& evaluation, std::string_view name) {
  for (const EvaluationRow& row : evaluation.rows)
    if (row.name == name) return &row;
  return nullptr;
}

Evaluation evaluate(const TrainTestSplit& split, const CostModel& cost_model,
                    std::span<const FittedMethod> methods, std::uint64_t seed, const Clock& clock) {
  Evaluation evaluation;
  evaluation.cost_model = cost_model;
  evaluation.labels = label(split.tested, cost_model);
  add_baselines(split, seed, evaluation);
  add_methods(split, methods, evaluation);
  add_oracle(split, evaluation);
  add_estimates(seed, evaluation);
  for (const FittedMethod& fitted : methods)
    evaluation.timing.push_back(timing_of(fitted, split.tested, clock));
  return evaluation;
}

double mean_cost_ns(std::span<const Observation> observations, const Labels& labels,
                    const Chooser& choose) {
  double sum = 0;
  for (std::size_t i = 0; i < observations.size(); ++i)
    sum += cost_of_choice(observations, labels, i, choose(observations[i]).best[0].clip);
  return sum / static_cast<double>(observations.size());
}

}  // namespace flinch::train
