// SPDX-License-Identifier: MIT
#include "train/evaluate/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/random.h"
#include "lookahead/oracle/oracle.h"
#include "models/baseline.h"
#include "motion/error.h"
#include "runtime/selection.h"
#include "train/evaluate/look_ahead_chooser.h"
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
        damage_ns(observation.trials[trial].impulse,
                  vulnerability_to(evaluation.cost_model, observation.scenario.threat.kind)));
    row.hit.push_back(chosen.clip == label ? 1 : 0);
    row.hit_in_three.push_back(contains(ranking, label) ? 1 : 0);
    row.vote.push_back(chosen.vote);
    row.expected_cost_ns.push_back(chosen.expected_cost_ns);
  }
  row.use = intended_use(split.header, split.tested, row.chosen);
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

/// Braces by the pose rules instead of playing a clip (runtime::Character::brace), simulated as the
/// clips were and with the costs of the first method. Adds no row if the store does not hold its
/// library.
void add_rules(const TrainTestSplit& split, std::span<const FittedMethod> methods,
               Evaluation& evaluation) {
  if (methods.empty()) return;
  const auto played = playable(split.header, methods.front().training.selector);
  if (!played) return;
  const lookahead::Oracle oracle(played->library);
  EvaluationRow row;
  row.name = "rules";
  for (std::size_t i = 0; i < split.tested.size(); ++i) {
    const features::Scenario& scenario = split.tested[i].scenario;
    const features::CharacterState& state = scenario.state;
    runtime::Character character(played->library);
    character.place(state.position, state.facing, state.idle_time_s, state.stance);
    const runtime::Perception perception{scenario, 0};
    const runtime::Response braced = character.plan_brace(perception);
    if (!is_valid(braced))
      throw Error("", "scenario " + std::to_string(split.tested[i].number) +
                          " cannot be answered by the pose rules");
    const lookahead::ClipTrial trial = oracle.try_response(braced, perception, scenario.threat);
    row.chosen.push_back(runtime::kNoClip);
    row.cost_ns.push_back(trial.cost_ns);
    row.damage_ns.push_back(trial.damage_ns);
    row.hit.push_back(0);
    row.hit_in_three.push_back(0);
    row.vote.push_back(0);
    row.expected_cost_ns.push_back(std::numeric_limits<float>::quiet_NaN());
  }
  evaluation.rows.push_back(std::move(row));
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

/// The rows that look ahead, and at how many candidates.
struct LookAheadPlan {
  std::string_view of;
  int candidates;
};
constexpr std::array<LookAheadPlan, 12> kLookAheadPlans{{{"random", 2},
                                                         {"random", 4},
                                                         {"random", 8},
                                                         {"random", 16},
                                                         {"nearest_annotation", 8},
                                                         {"knn", 8},
                                                         {"svm", 8},
                                                         {"pairwise_cost", 8},
                                                         {"network", 2},
                                                         {"network", 4},
                                                         {"network", 8},
                                                         {"network", 16}}};

std::vector<models::Candidate> proposals(const std::vector<int>& clips) {
  std::vector<models::Candidate> proposed;
  for (const int clip : clips) proposed.push_back({.clip = clip});
  return proposed;
}

/// All allowed clips in a random order.
std::vector<int> shuffled_allowed(const StoreHeader& header, const Observation& observation,
                                  std::uint64_t seed) {
  const models::ClipMask allowed =
      models::allowed_clips(header.clips, header.idle, observation.scenario.target);
  std::vector<int> clips;
  for (std::size_t i = 0; i < allowed.size(); ++i)
    if (allowed[i]) clips.push_back(static_cast<int>(i));
  features::Random random(seed, features::RandomStream::baseline, observation.number);
  for (std::size_t left = clips.size(); left > 1; --left)
    std::swap(clips[left - 1], clips[random.bits() % left]);
  return clips;
}

Proposer proposer_of(const LookAheadPlan& plan, const StoreHeader& header,
                     const models::Selector& selector, std::uint64_t seed) {
  if (plan.of == "random")
    return [&header, seed](const Observation& observation) {
      return proposals(shuffled_allowed(header, observation, seed));
    };
  if (plan.of == "nearest_annotation")
    return [&header](const Observation& observation) {
      return proposals(models::nearest_annotations(header.clips, header.idle,
                                                   observation.scenario.target,
                                                   azimuth_of(observation.scenario)));
    };
  const auto count = static_cast<std::size_t>(plan.candidates);
  return [&selector, count](const Observation& observation) {
    const auto candidates =
        models::candidates(selector, observation.features, observation.scenario.target,
                           std::pmr::get_default_resource(), count);
    return std::vector<models::Candidate>(candidates.begin(), candidates.end());
  };
}

double quantile(const std::vector<double>& sorted, double share);

/// Baselines look ahead with the costs of the first method.
void add_look_ahead(const TrainTestSplit& split, std::span<const FittedMethod> methods,
                    std::uint64_t seed, const Clock& clock, Evaluation& evaluation) {
  for (const LookAheadPlan& plan : kLookAheadPlans) {
    const bool is_baseline = plan.of == "random" || plan.of == "nearest_annotation";
    const auto method =
        is_baseline ? methods.begin() : std::ranges::find_if(methods, [&](const auto& fitted) {
          return name_of(fitted.method) == plan.of;
        });
    if (method == methods.end()) continue;
    const models::Selector& selector = method->training.selector;
    const auto played = playable(split.header, selector);
    if (!played) return;
    LookAheadChooser chooser(*played, plan.candidates,
                             proposer_of(plan, split.header, selector, seed), clock);
    LookAheadRow added{row_of(std::string(plan.of) + '+' + std::to_string(plan.candidates), split,
                              evaluation, std::ref(chooser)),
                       plan.candidates, 0, 0, chooser.encounters_per_choice()};
    std::vector<double> took_s = chooser.took_s();
    std::ranges::sort(took_s);
    added.median_us = 1e6 * quantile(took_s, 0.5);
    added.p99_us = 1e6 * quantile(took_s, 0.99);
    evaluation.look_ahead.push_back(std::move(added));
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

RowMeans means_of(const EvaluationRow& row, const Resamples& resamples) {
  const auto of = [&](const std::vector<double>& values) {
    return resampled_mean(values, resamples);
  };
  return {of(row.cost_ns), of(row.damage_ns), of(row.hit), of(row.hit_in_three)};
}

/// Sets a row's estimates, except its differences from other rows.
void set_estimates(const RowMeans& means, const ResampledMean& idle, const ResampledMean& oracle,
                   EvaluationRow& row) {
  const auto itself = [](double mean) { return mean; };
  row.accuracy = estimate(itself, means.hit);
  row.top_three = estimate(itself, means.hit_in_three);
  row.mean_cost_ns = estimate(itself, means.cost);
  row.mean_damage_ns = estimate(itself, means.damage);
  row.regret_ns = estimate(std::minus{}, means.cost, oracle);
  row.protection = estimate(protection_of, idle, means.cost, oracle);
}

void add_estimates(std::uint64_t seed, Evaluation& evaluation) {
  const Resamples resamples = draw_resamples(evaluation.labels.clip.size(), kResampleCount, seed);
  std::vector<RowMeans> means;
  for (const EvaluationRow& row : evaluation.rows) means.push_back(means_of(row, resamples));
  const ResampledMean& idle = means.front().cost;
  const ResampledMean& oracle = means.back().cost;
  for (LookAheadRow& ahead : evaluation.look_ahead)
    set_estimates(means_of(ahead.row, resamples), idle, oracle, ahead.row);
  for (std::size_t i = 0; i < evaluation.rows.size(); ++i) {
    EvaluationRow& row = evaluation.rows[i];
    const ResampledMean& cost = means[i].cost;
    set_estimates(means[i], idle, oracle, row);
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
                                      std::uint64_t seed, const Clock& clock,
                                      const ProgressCallback& progress) {
  std::vector<FittedMethod> fitted;
  for (const Method method : methods) {
    progress(std::string(name_of(method)));
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
  add_rules(split, methods, evaluation);
  add_methods(split, methods, evaluation);
  add_oracle(split, evaluation);
  add_look_ahead(split, methods, seed, clock, evaluation);
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
