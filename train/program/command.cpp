// SPDX-License-Identifier: MIT
#include "train/program/command.h"

#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

namespace flinch::train::program {

void add_json_option(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print one JSON document and nothing else");
}

void print(const Json& document) {
  std::cout << document.dump(2) << '\n';
}

void add_cost_options(CLI::App& command, CostOptions& options) {
  command.add_option("--brawn", options.brawn, "how much work weighs against damage, from 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const VulnerabilityProfile& profile : vulnerability_profiles())
    names.emplace_back(profile.name);
  command
      .add_option("--vulnerability", options.vulnerability,
                  "which table says how much an impulse on each body hurts")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

const Vulnerability& vulnerability_of(const CostOptions& options) {
  return vulnerability_profile_named(options.vulnerability)->vulnerability;
}

double degrees(double radians) {
  return std::round(radians * 180e6 / std::numbers::pi) / 1e6;
}

Json to_json(const models::ClipSummary& clip) {
  if (!clip.annotation) return {};
  const motion::Annotation& annotation = *clip.annotation;
  return {{"target", motion::name_of(annotation.target)},
          {"direction_degrees", std::round(degrees(double{annotation.direction}))},
          {"degree", motion::name_of(annotation.degree)},
          {"onset_s", annotation.onset_s},
          {"peak_s", annotation.peak_s},
          {"end_s", annotation.end_s}};
}

}  // namespace flinch::train::program
