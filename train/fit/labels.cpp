// SPDX-License-Identifier: MIT
#include "train/fit/labels.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "motion/error.h"

namespace flinch::train {

namespace {

/// The tables of a profile against kinds of threats that the store has. Throws Error for others.
std::vector<features::KindVulnerability> tables_of_kinds(const StoreHeader& header,
                                                         const VulnerabilityProfile& profile) {
  std::vector<features::KindVulnerability> tables;
  for (const VulnerabilityProfile::OfKind& table : profile.of_kind) {
    const auto kind = std::ranges::find(header.kinds, table.kind, &features::KnownKind::name);
    if (kind == header.kinds.end()) {
      std::string names;
      for (const features::KnownKind& known : header.kinds)
        names += (names.empty() ? "" : ", ") + known.name;
      throw Error(table.where, "[kind." + table.kind +
                                   "] is for a kind of threat that the store does not have; it "
                                   "has: " +
                                   names);
    }
    tables.push_back({static_cast<int>(kind - header.kinds.begin()), table.vulnerability});
  }
  std::ranges::sort(tables, {}, &features::KindVulnerability::kind);
  return tables;
}

}  // namespace

CostModel make_cost_model(const StoreHeader& header, const VulnerabilityProfile& profile,
                          double brawn) {
  CostModel model;
  model.vulnerability = profile.vulnerability;
  model.of_kind = tables_of_kinds(header, profile);
  model.brawn = brawn;
  model.reference_damage_ns.clear();
  for (std::size_t kind = 0; kind < header.kinds.size(); ++kind)
    model.reference_damage_ns.push_back(
        reference_damage_ns(vulnerability_to(model, static_cast<int>(kind)), header.kinds[kind]));
  model.reference_work_j = header.reference_work_j;
  model.vulnerability_name = profile.name;
  return model;
}

Labels label(std::span<const Observation> observations, const CostModel& model) {
  Labels labels;
  for (const Observation& observation : observations) {
    labels.cost.push_back(costs_of(observation.trials, observation.scenario.threat.kind, model));
    const std::size_t best = best_trial(observation.trials, labels.cost.back());
    labels.clip.push_back(observation.trials[best].clip);
    if (model.reference_damage_ns.size() == 1) continue;
    const auto kind = static_cast<std::size_t>(observation.scenario.threat.kind);
    labels.unit.push_back(
        static_cast<float>(model.reference_damage_ns[kind] / model.reference_damage_ns.front()));
  }
  return labels;
}

double cost_of_choice(std::span<const Observation> observations, const Labels& labels,
                      std::size_t observation, int clip) {
  return labels.cost[observation][trial_of(observations[observation], clip)];
}

features::Scaling scaling_of(const StoreHeader& header, std::span<const Observation> observations) {
  std::vector<features::FeatureVector> rows;
  rows.reserve(observations.size());
  for (const Observation& observation : observations) rows.push_back(observation.features);
  return features::make_scaling(rows, header.layout.names());
}

models::TrainingSet make_training_set(const StoreHeader& header,
                                      std::span<const Observation> observations,
                                      const Labels& labels, const features::Scaling& scaling) {
  models::TrainingSet set;
  set.feature_count = header.layout.size();
  set.idle = header.idle;
  for (const motion::Target target : motion::kTargets) {
    set.masks.push_back(models::allowed_clips(header.clips, header.idle, target));
  }
  std::vector<double> scaled(static_cast<std::size_t>(set.feature_count));
  for (const Observation& observation : observations) {
    scaling.apply(observation.features, scaled);
    set.points.insert(set.points.end(), scaled.begin(), scaled.end());
    set.mask.push_back(static_cast<int>(observation.scenario.target));
  }
  set.label = labels.clip;
  set.unit = labels.unit;
  const std::size_t clips = header.clips.size();
  set.cost.assign(observations.size() * clips, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const std::vector<Trial>& trials = observations[i].trials;
    for (std::size_t t = 0; t < trials.size(); ++t) {
      const auto clip = static_cast<std::size_t>(trials[t].clip);
      set.cost[i * clips + clip] = static_cast<float>(labels.cost[i][t]);
    }
  }
  return set;
}

}  // namespace flinch::train
