// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "program/document.h"
#include "program/options.h"
#include "train/objective/cost.h"

namespace flinch::program {

/// The commands, each with destinations of its own for its options.
Command author_command();
Command import_command();
Command info_command();
Command simulate_command();
Command merge_command();
Command train_command();
Command compare_command();
Command export_command();
Command select_command();
Command respond_command();

/// --json, as all commands but simulate describe it.
Option json_option(bool& json);

/// The option that says with which features selectors are asked; `set` becomes the default.
Option features_option(std::string& set);

/// The names of all methods.
std::vector<std::string> method_names();

/// How scenarios are labelled, as options say it.
struct CostOptions {
  double brawn = 0.1;
  std::string vulnerability{train::vulnerability_profiles()[0].name};
};
std::vector<Option> cost_options(CostOptions& options);
const train::Vulnerability& vulnerability_of(const CostOptions& options);

}  // namespace flinch::program
