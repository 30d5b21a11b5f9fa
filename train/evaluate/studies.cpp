// SPDX-License-Identifier: MIT
#include "train/evaluate/studies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/random.h"
#include "train/fit/feature_derivation.h"

namespace flinch::train {
namespace {

constexpr std::array kNoiseLevels{0.0, 0.02, 0.05, 0.1, 0.2};
constexpr std::array<std::size_t, 7> kLearningCurveSizes{500,    1000,   2000,  5000,
                                                         10'000, 20'000, 50'000};
constexpr std::array kBrawns{0.0, 0.1, 0.3, 0.5};

/// Scores a choice of clips.
struct ChoiceScorer {
  ChoiceScorer(const TrainTestSplit& split, const CostModel& cost_model)
      : observations(split.tested), labels(label(split.tested, cost_model)) {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      idle_ns += cost_of_choice(observations, labels, i, split.header.idle);
      oracle_ns += cost_of_choice(observations, labels, i, labels.clip[i]);
    }
    idle_ns /= static_cast<double>(observations.size());
    oracle_ns /= static_cast<double>(observations.size());
  }

  /// Sets the row's regret and protection.
  template <class Row>
  Row scored(Row row, const Chooser& choose) const {
    const double cost = mean_cost_ns(observations, labels, choose);
    row.regret_ns = cost - oracle_ns;
    row.protection = protection_of(idle_ns, cost, oracle_ns);
    return row;
  }

  const std::vector<Observation>& observations;
  Labels labels;
  double idle_ns = 0;    ///< mean cost
  double oracle_ns = 0;  ///< mean cost
};

Chooser chooser_of(const models::Selector& selector) {
  return [&selector](const Observation& observation) {
    return ranking_of(selector, observation.features, observation.scenario.target);
  };
}

Training train(const StudyPlan& plan, Method method, std::size_t count) {
  return train_selector(plan.split.header, std::span(plan.split.fitted).first(count),
                        plan.cost_model, method, plan.seed);
}

features::FeatureVector with_noise(const models::Selector& selector, const Observation& observation,
                                   double level, std::uint64_t seed) {
  features::Random random(seed, features::RandomStream::noise, observation.number);
  features::FeatureVector noisy = observation.features;
  for (int i = 0; i < selector.layout.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double normal = random.normal();
    const std::string_view name = selector.layout.name(i);
    if (name.starts_with("target_") || name.starts_with("kind_")) continue;
    const double half_range = 0.5 * (selector.scaling.max[k] - selector.scaling.min[k]);
    noisy[k] += static_cast<float>(level * half_range * normal);
  }
  return noisy;
}

struct NamedLayout {
  std::string name;
  features::Layout layout;
};

std::vector<NamedLayout> ablated_layouts(const StoreHeader& header) {
  std::vector<NamedLayout> layouts;
  for (const features::FeatureSet& set : features::feature_sets()) {
    const std::string name(set.name);
    const features::Layout all = layout_for(name, header);
    layouts.push_back({name, all});
    const features::Layout alike = header.stances.empty() ? set.layout : with_stances(set.layout);
    if (all != alike) layouts.push_back({name + " without size, mass and kind", alike});
    const features::Layout still = with_kinds(set.layout, header.kinds);
    if (all != still) layouts.push_back({name + " without the stance", still});
    for (const features::FeatureGroup& group : features::feature_groups()) {
      const features::Layout less = without(all, group);
      if (less != all) layouts.push_back({name + " without " + std::string(group.name), less});
    }
  }
  return layouts;
}

}  // namespace

std::vector<MethodSummary> summaries_of(std::span<const FittedMethod> methods) {
  std::vector<MethodSummary> summaries;
  for (const FittedMethod& fitted : methods)
    summaries.push_back({std::string(name_of(fitted.method)), fitted.training.parameter_values,
                         fitted.training.parameters, fitted.training.cross_validated_regret_ns});
  return summaries;
}

std::vector<NoiseRow> noise_rows(const StudyPlan& plan, std::span<const FittedMethod> methods) {
  const ChoiceScorer scorer(plan.split, plan.cost_model);
  std::vector<NoiseRow> rows;
  for (const FittedMethod& fitted : methods) {
    const models::Selector& selector = fitted.training.selector;
    for (const double level : kNoiseLevels) {
      const auto choose = [&](const Observation& observation) {
        return ranking_of(selector, with_noise(selector, observation, level, plan.seed),
                          observation.scenario.target);
      };
      rows.push_back(
          scorer.scored(NoiseRow{std::string(name_of(fitted.method)), level, 0, 0}, choose));
    }
  }
  return rows;
}

std::vector<LearningCurveRow> learning_curve_rows(const StudyPlan& plan,
                                                  const ProgressCallback& progress) {
  const ChoiceScorer scorer(plan.split, plan.cost_model);
  const std::size_t all = plan.split.fitted.size();
  std::vector<std::size_t> sizes;
  for (const std::size_t size : kLearningCurveSizes)
    if (size < all) sizes.push_back(size);
  sizes.push_back(all);
  std::vector<LearningCurveRow> rows;
  for (const Method method : plan.methods) {
    for (const std::size_t size : sizes) {
      const std::string name(name_of(method));
      progress(name + " of " + std::to_string(size) + " scenarios");
      const Training training = train(plan, method, size);
      rows.push_back(
          scorer.scored(LearningCurveRow{name, size, 0, 0}, chooser_of(training.selector)));
    }
  }
  return rows;
}

std::vector<TransferRow> transfer_rows(const StudyPlan& plan, const ProgressCallback& progress) {
  std::vector<CostModel> models;
  std::vector<ChoiceScorer> scorers;
  scorers.reserve(kBrawns.size());
  for (const double brawn : kBrawns) {
    models.push_back(plan.cost_model);
    models.back().brawn = brawn;
    scorers.emplace_back(plan.split, models.back());
  }
  std::vector<TransferRow> rows;
  for (const Method method : plan.methods) {
    const std::string name(name_of(method));
    for (const CostModel& model : models) {
      progress(name + " for brawn " + std::to_string(std::lround(100 * model.brawn)) + " %");
      const Training training =
          train_selector(plan.split.header, plan.split.fitted, model, method, plan.seed);
      for (std::size_t i = 0; i < scorers.size(); ++i) {
        rows.push_back(scorers[i].scored(TransferRow{name, model.brawn, kBrawns[i], 0, 0},
                                         chooser_of(training.selector)));
      }
    }
  }
  return rows;
}

std::vector<AblationRow> ablation_rows(const StudyPlan& plan, const ProgressCallback& progress) {
  TrainTestSplit split = plan.split;
  std::vector<AblationRow> rows;
  for (const NamedLayout& named : ablated_layouts(split.header)) {
    derive_features(named.layout, split.header, split.fitted);
    derive_features(named.layout, split.header, split.tested);
    split.header.layout = named.layout;
    const ChoiceScorer scorer(split, plan.cost_model);
    for (const Method method : plan.methods) {
      const std::string name(name_of(method));
      progress(name + " with " + named.name);
      const Training training =
          train_selector(split.header, split.fitted, plan.cost_model, method, plan.seed);
      rows.push_back(scorer.scored(AblationRow{name, named.name, named.layout.size(),
                                               training.cross_validated_regret_ns, 0, 0},
                                   chooser_of(training.selector)));
    }
  }
  return rows;
}

}  // namespace flinch::train
