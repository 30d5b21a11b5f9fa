// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "program/command.h"
#include "train/scenario/threat_file.h"
#include "train/simulate/simulate.h"

namespace flinch::program {

namespace {

struct ThreatsOptions {
  std::string name{train::threat_files().front().name};
  bool json = false;
};

void run_threats(const ThreatsOptions& options) {
  if (options.json) {
    Json document{{"kind", "threats"}, {"name", options.name}};
    document.update(Json::parse(train::describe(train::find_threats(options.name))));
    print(document);
    return;
  }
  for (const train::ThreatFile& file : train::threat_files())
    if (file.name == options.name) std::cout << file.text;
}

}  // namespace

std::vector<std::string> threat_file_names() {
  std::vector<std::string> names;
  for (const train::ThreatFile& file : train::threat_files()) names.emplace_back(file.name);
  return names;
}

Command threats_command() {
  auto options = std::make_shared<ThreatsOptions>();
  return {
      .name = "threats",
      .summary = "Print shipped threats as TOML, to start from",
      .required = {},
      .optional = {{"--name", "which of them", &options->name, OneOf{threat_file_names()}},
                   json_option(options->json)},
      .notes =
          "docs/threats.md explains the keys.\n\n"
          "Example:\n  flinch threats --name balls > threats.toml\n"
          "  flinch simulate real.flinchlib --out real.flinchobs -n 2000 --threats threats.toml",
      .run = [options] { run_threats(*options); }};
}

}  // namespace flinch::program
