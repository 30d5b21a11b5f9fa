// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "program/document.h"
#include "train/objective/cost.h"

namespace flinch::program {

/// Each adds one command with its options to the program; parsing a command line with it runs it.
/// Commands throw Error for what a user can put right.
void add_author(CLI::App& program);
void add_import(CLI::App& program);
void add_info(CLI::App& program);
void add_simulate(CLI::App& program);
void add_merge(CLI::App& program);
void add_train(CLI::App& program);
void add_compare(CLI::App& program);
void add_export(CLI::App& program);
void add_select(CLI::App& program);
void add_respond(CLI::App& program);

/// The option that every command has.
void add_json_option(CLI::App& command, bool& json);

/// Accepts numbers from `min` to `max`; unlike CLI::Range, nan is not one.
CLI::Validator number_in(double min, double max);

/// The option that says with which features selectors are asked; `set` becomes the default.
void add_features_option(CLI::App& command, std::string& set);

/// The names of all methods.
std::vector<std::string> method_names();

/// How scenarios are labelled, as options say it.
struct CostOptions {
  double brawn = 0.1;
  std::string vulnerability{train::vulnerability_profiles()[0].name};
};
void add_cost_options(CLI::App& command, CostOptions& options);
const train::Vulnerability& vulnerability_of(const CostOptions& options);

}  // namespace flinch::program
