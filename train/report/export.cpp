// SPDX-License-Identifier: MIT
#include "train/report/export.h"

#include "train/report/csv.h"

namespace flinch::train {
namespace {

std::string header_line(const StoreHeader& header) {
  std::string text = "number,target";
  for (const std::string& name : header.layout.names()) text += ',' + name;
  text += ",label,clip,cost_ns,idle_cost_ns";
  std::vector<std::string> clips;
  for (const models::ClipSummary& clip : header.clips) clips.push_back(clip.name);
  for (const std::string& name : column_names("cost_ns_", clips)) text += ',' + name;
  return text + '\n';
}

/// One cell per clip of the library.
std::string clip_costs(const StoreHeader& header, const Observation& observation,
                       const std::vector<double>& costs) {
  std::vector<std::string> cells(header.clips.size());
  for (std::size_t i = 0; i < costs.size(); ++i)
    cells[static_cast<std::size_t>(observation.trials[i].clip)] = exact_text(costs[i]);
  std::string text;
  for (const std::string& cell : cells) text += ',' + cell;
  return text;
}

}  // namespace

std::string libsvm_text(const Store& store, const Labels& labels,
                        const features::Scaling& scaling) {
  std::vector<double> scaled(scaling.min.size());
  std::string text;
  for (std::size_t i = 0; i < store.observations.size(); ++i) {
    scaling.apply(store.observations[i].features, scaled);
    text += std::to_string(labels.clip[i]);
    for (std::size_t k = 0; k < scaled.size(); ++k)
      text += ' ' + std::to_string(k + 1) + ':' + exact_text(scaled[k]);
    text += '\n';
  }
  return text;
}

std::string csv_text(const Store& store, const Labels& labels) {
  std::string text = header_line(store.header);
  for (std::size_t i = 0; i < store.observations.size(); ++i) {
    const Observation& observation = store.observations[i];
    const int label = labels.clip[i];
    text += std::to_string(observation.number) + ',' +
            std::string(motion::name_of(observation.scenario.target));
    for (int k = 0; k < store.header.layout.size(); ++k)
      text += ',' + exact_text(double{observation.features[static_cast<std::size_t>(k)]});
    text += ',' + std::to_string(label) + ',' +
            csv_cell(store.header.clips[static_cast<std::size_t>(label)].name) + ',' +
            exact_text(cost_of_choice(store.observations, labels, i, label)) + ',' +
            exact_text(cost_of_choice(store.observations, labels, i, store.header.idle)) +
            clip_costs(store.header, observation, labels.cost[i]) + '\n';
  }
  return text;
}

}  // namespace flinch::train
