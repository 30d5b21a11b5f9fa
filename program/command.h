// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/files/output_check.h"
#include "program/document.h"
#include "program/options.h"
#include "sim/simulation_options.h"
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::program {

/// The commands. Each call returns a command with its own destinations for options.
Command author_command();
Command import_command();
Command annotate_command();
Command info_command();
Command simulate_command();
Command merge_command();
Command train_command();
Command compare_command();
Command export_command();
Command select_command();
Command respond_command();
Command threats_command();
Command view_command();
Command evolve_command();
Command push_command();
Command label_command();
Command train_realism_command();

/// The option --json, for all commands except simulate.
Option json_option(bool& json);

/// The option --threads, for commands that compute on several.
Option threads_option(std::optional<int>& threads);

/// The option --force, for all commands that write files.
Option force_option(bool& force);
/// What --force means for existing files.
database::Overwrite overwrite_of(bool force);

/// Creates a folder, and those above it that are missing. Throws Error.
void create_folder(const std::string& folder);

/// The option --figure, the name of the figure that tracks motions.
Option figure_option(std::string& figure);
/// Returns the figure with a name that the command line has accepted.
sim::FigureKind figure_of(const std::string& name);

/// The option that selects the features of selectors; `set` becomes the default.
Option features_option(std::string& set);

/// Returns the names of the shipped distributions of threats.
std::vector<std::string> threat_file_names();

/// Returns the names of all methods.
std::vector<std::string> method_names();

/// How to label scenarios, as given by options.
struct CostOptions {
  double brawn = train::CostModel{}.brawn;
  std::string vulnerability{train::vulnerability_profiles()[0].name};  ///< or a file
  std::optional<std::string> pain;  ///< name of a pain map, or a file: in place of `vulnerability`
};
std::vector<Option> cost_options(CostOptions& options);
/// The same, and --pain: for commands that label stores.
std::vector<Option> label_options(CostOptions& options);
/// Returns the file that the options name, or an empty path.
std::string vulnerability_file(const CostOptions& options);
/// Returns the vulnerability table that the options name; with a pain map, that of
/// evolve::largest_pain. Throws Error.
train::VulnerabilityProfile vulnerability_of(const CostOptions& options);
/// Reads a store whose damage, by this table, is what the options name.
train::Store read_labelled_store(const std::string& path, const CostOptions& options);

}  // namespace flinch::program
