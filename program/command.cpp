// SPDX-License-Identifier: MIT
#include "program/command.h"

#include <sstream>
#include <vector>

#include "features/feature_layout.h"
#include "train/fit/training.h"

namespace flinch::program {

void add_json_option(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print one JSON document and nothing else");
}

CLI::Validator number_in(double min, double max) {
  std::ostringstream range;
  range << "[" << min << " - " << max << "]";
  const auto refusal = [min, max, text = range.str()](const std::string& input) {
    double value = 0;
    const bool in_range = CLI::detail::lexical_cast(input, value) && value >= min && value <= max;
    return in_range ? std::string() : "Value " + input + " not in range " + text;
  };
  return {refusal, "NUMBER in " + range.str()};
}

void add_features_option(CLI::App& command, std::string& set) {
  std::vector<std::string> names;
  std::string summaries;
  for (const features::FeatureSet& known : features::feature_sets()) {
    names.emplace_back(known.name);
    summaries += (summaries.empty() ? "" : "; ") + names.back() + ": " + std::string(known.summary);
  }
  set = names.front();
  command
      .add_option("--features", set, "what a selector is told of a scenario (" + summaries + ")")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const train::Method method : train::methods()) names.emplace_back(train::name_of(method));
  return names;
}

void add_cost_options(CLI::App& command, CostOptions& options) {
  command.add_option("--brawn", options.brawn, "how much work weighs against damage, from 0 to 1")
      ->check(number_in(0, 1))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const train::VulnerabilityProfile& profile : train::vulnerability_profiles())
    names.emplace_back(profile.name);
  command
      .add_option("--vulnerability", options.vulnerability,
                  "which table says how much an impulse on each body hurts")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

const train::Vulnerability& vulnerability_of(const CostOptions& options) {
  return train::vulnerability_profile_named(options.vulnerability)->vulnerability;
}

}  // namespace flinch::program
