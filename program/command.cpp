// SPDX-License-Identifier: MIT
#include "program/command.h"

#include <filesystem>

#include "database/files/file_kind.h"
#include "features/feature_layout.h"
#include "motion/error.h"
#include "train/fit/training.h"

namespace flinch::program {

Option json_option(bool& json) {
  return {"--json", "print one JSON document and nothing else", &json};
}

Option force_option(bool& force) {
  return {"--force", "replace an existing file of any kind, except one that the command reads",
          &force};
}

database::Overwrite overwrite_of(bool force) {
  return force ? database::Overwrite::force : database::Overwrite::refuse;
}

void create_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(folder, "cannot create this folder: " + error.message());
}

Option features_option(std::string& set) {
  std::vector<std::string> names;
  std::string summaries;
  for (const features::FeatureSet& known : features::feature_sets()) {
    names.emplace_back(known.name);
    summaries += (summaries.empty() ? "" : "; ") + names.back() + ": " + std::string(known.summary);
  }
  set = names.front();
  return {"--features", "the features that a selector sees (" + summaries + ")", &set,
          OneOf{names}};
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const train::Method method : train::methods()) names.emplace_back(train::name_of(method));
  return names;
}

std::vector<Option> cost_options(CostOptions& options) {
  std::vector<std::string> names;
  for (const train::VulnerabilityProfile& profile : train::vulnerability_profiles())
    names.push_back(profile.name);
  return {{"--brawn", "weight of work against damage, from 0 to 1", &options.brawn, Range{0, 1}},
          {"--vulnerability", "table of how much an impulse on each body hurts",
           &options.vulnerability, OneOfOrFile{names, ".toml"}}};
}

std::string vulnerability_file(const CostOptions& options) {
  return database::names_toml_file(options.vulnerability) ? options.vulnerability : "";
}

train::VulnerabilityProfile vulnerability_of(const CostOptions& options) {
  return train::find_vulnerability(options.vulnerability);
}

}  // namespace flinch::program
