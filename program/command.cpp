// SPDX-License-Identifier: MIT
#include "program/command.h"

#include <filesystem>

#include "database/files/file_kind.h"
#include "evolve/label/pain_labels.h"
#include "features/feature_layout.h"
#include "motion/error.h"
#include "train/fit/training.h"

namespace flinch::program {
namespace {

constexpr const char* kThesisPain = "thesis";

evolve::PainMap pain_map_of(const std::string& name) {
  return name == kThesisPain ? evolve::thesis_pain() : evolve::read_pain(name);
}

}  // namespace

Option json_option(bool& json) {
  return {"--json", "print one JSON document and nothing else", &json};
}

Option force_option(bool& force) {
  return {"--force", "replace an existing file of any kind, except one that the command reads",
          &force};
}

Option threads_option(std::optional<int>& threads) {
  return {"--threads", "number of threads (default: one per processor)", &threads, Range{1, 1024}};
}

database::Overwrite overwrite_of(bool force) {
  return force ? database::Overwrite::force : database::Overwrite::refuse;
}

void create_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(folder, "cannot create this folder: " + error.message());
}

Option figure_option(std::string& figure) {
  return {
      "--figure",
      "the figure that is simulated: people; waist_up: the character of Rose (2006), appendix A",
      &figure, OneOf{{"people", "waist_up"}}};
}

sim::FigureKind figure_of(const std::string& name) {
  return name == "waist_up" ? sim::FigureKind::waist_up : sim::FigureKind::people;
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

std::vector<Option> label_options(CostOptions& options) {
  return join({cost_options(options),
               {{"--pain",
                 "in place of --vulnerability, how much an impulse hurts at each place: the map of "
                 "Rose (2006), or a file; the store needs simulate's --places",
                 &options.pain, OneOfOrFile{{kThesisPain}, ".toml"}}}});
}

std::string vulnerability_file(const CostOptions& options) {
  if (options.pain) return database::names_toml_file(*options.pain) ? *options.pain : "";
  return database::names_toml_file(options.vulnerability) ? options.vulnerability : "";
}

train::VulnerabilityProfile vulnerability_of(const CostOptions& options) {
  if (options.pain) {
    if (options.vulnerability != CostOptions{}.vulnerability)
      throw Error("", "--pain and --vulnerability both say what hurts; give one of them");
    return evolve::largest_pain(pain_map_of(*options.pain), "pain");
  }
  return train::find_vulnerability(options.vulnerability);
}

train::Store read_labelled_store(const std::string& path, const CostOptions& options) {
  train::Store store = train::read_store(path);
  if (options.pain) evolve::relabel_by_pain(pain_map_of(*options.pain), store, path);
  return store;
}

}  // namespace flinch::program
