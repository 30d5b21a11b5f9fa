// SPDX-License-Identifier: MIT
#include "train/export.h"

#include <array>
#include <charconv>

namespace flinch::train {

std::string exact(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

std::string libsvm_text(std::span<const Observation> observations, const Labels& labels) {
  const features::Scaling scaling = scaling_of(observations);
  std::array<double, features::kFeatureCount> scaled{};
  std::string text;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    scaling.apply(observations[i].features, scaled);
    text += std::to_string(labels.clip[i]);
    for (std::size_t k = 0; k < scaled.size(); ++k)
      text += ' ' + std::to_string(k + 1) + ':' + exact(scaled[k]);
    text += '\n';
  }
  return text;
}

std::string csv_text(const Store& store, const Labels& labels) {
  std::string text = "number,target";
  for (const std::string_view name : features::kFeatureNames) text += ',' + std::string(name);
  text += ",label,clip,cost_ns,idle_cost_ns\n";
  for (std::size_t i = 0; i < store.observations.size(); ++i) {
    const Observation& observation = store.observations[i];
    const int label = labels.clip[i];
    text += std::to_string(observation.number) + ',' +
            std::string(motion::name_of(observation.scenario.target));
    for (const float value : observation.features) text += ',' + exact(double{value});
    text += ',' + std::to_string(label) + ',' +
            csv_cell(store.header.clips[static_cast<std::size_t>(label)].name) + ',' +
            exact(cost_of_choice(store.observations, labels, i, label)) + ',' +
            exact(cost_of_choice(store.observations, labels, i, store.header.idle)) + '\n';
  }
  return text;
}

}  // namespace flinch::train
